# SPDX-License-Identifier: GPL-3.0-or-later
import json
import math
import sqlite3
import xml.etree.ElementTree as xml

import numpy as np
import pytest
import roomatlas


def shoelace_m2(ring):
    x, y = ring[:, 0], ring[:, 1]
    return abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2


def test_rooms_are_those_of_the_world(building, world):
    true_m2 = sorted(f["properties"]["area_m2"] for f in json.loads(world.read_text())["features"]
                     if "area_m2" in f["properties"])
    found_m2 = sorted(room.area_m2 for room in building.rooms)
    assert len(found_m2) == 2
    if true_m2:
        assert found_m2 == pytest.approx(true_m2, rel=0.1)


def test_areas_are_those_of_the_rings_and_of_shapely(building):
    shapely = pytest.importorskip("shapely.geometry")
    for room in building.rooms:
        by_hand_m2 = sum(shoelace_m2(outer) - sum(map(shoelace_m2, holes))
                         for outer, holes in room.rings)
        assert room.area_m2 == pytest.approx(by_hand_m2, abs=0.01)
        assert room.polygon.is_valid
        assert room.polygon.area == pytest.approx(by_hand_m2, abs=1e-9)
        assert room.polygon.contains(shapely.Point(room.label_point))


def test_doors_join_rooms_and_lie_between_them(building):
    assert len(building.doors) == 1
    (door,) = building.doors
    assert door.rooms == tuple(room.id for room in building.rooms)
    assert np.linalg.norm(door.jambs[0] - door.jambs[1]) == pytest.approx(door.width_m, abs=0.01)
    pytest.importorskip("shapely")
    for room in building.rooms:
        assert room.polygon.distance(door.line) < 0.5


def test_graph_has_the_rooms_and_their_way(building):
    networkx = pytest.importorskip("networkx")
    first, second = building.rooms
    (door,) = building.doors
    middle = door.jambs.mean(axis=0)
    way_m = math.dist(first.label_point, middle) + math.dist(second.label_point, middle)
    assert networkx.shortest_path_length(
        building.graph, first.id, second.id, weight="length_m") == pytest.approx(way_m)


def test_trajectory_is_nearer_to_the_truth_than_odometry(building, mission):
    truth = np.loadtxt(mission.truth_poses)
    assert building.trajectory.shape == building.odometry.shape
    assert building.trajectory.shape[1] == 4
    np.testing.assert_array_equal(building.trajectory[:, 0], building.odometry[:, 0])

    def off_m(path):  # after the best rigid fit, by Kabsch's method
        true_xy = np.column_stack([np.interp(path[:, 0], truth[:, 0], truth[:, k])
                                   for k in (1, 2)])
        a, b = path[:, 1:3] - path[:, 1:3].mean(0), true_xy - true_xy.mean(0)
        u, _, vt = np.linalg.svd(a.T @ b)
        turn = vt.T @ np.diag([1, np.linalg.det(vt.T @ u.T)]) @ u.T
        return np.linalg.norm(a @ turn.T - b, axis=1).mean()

    assert off_m(building.trajectory) < off_m(building.odometry) / 2
    figures = building.evaluate(mission.truth_poses)["true_poses"]["after"]["fitted_position_m"]
    assert figures["mean"] == pytest.approx(off_m(building.trajectory), abs=0.01)


def test_trajectory_is_evos_where_evo_is(building):
    pytest.importorskip("evo")
    path = building.evo_trajectory()
    np.testing.assert_allclose(path.timestamps, building.trajectory[:, 0])
    assert path.check()[0]


def test_a_notebook_shows_the_plan(building):
    page = xml.fromstring(building.plan._repr_svg_())
    assert page.tag.endswith("svg")
    html = building._repr_html_()
    assert html.count("<svg") == 1 and "<?xml" not in html
    assert xml.fromstring(html[html.index("<svg"):]).get("viewBox")
    assert "2 rooms" in html and "2 rooms, 1 door>" in repr(building)


def test_plans_are_saved_by_their_names(building, tmp_path):
    building.plan.save(tmp_path / "plan.svg")
    assert (tmp_path / "plan.svg").read_text() == building.plan.svg()
    building.plan.save(tmp_path / "plan.geojson")
    assert json.loads((tmp_path / "plan.geojson").read_text()) == building.plan.geojson()
    with pytest.raises(roomatlas.UsageError, match="plan.png"):
        building.plan.save(tmp_path / "plan.png")


def test_rooms_are_found_by_name(building):
    assert building.plan.room(building.rooms[1].name) is building.rooms[1]
    with pytest.raises(KeyError, match="cellar"):
        building.plan.room("cellar")


def test_a_store_is_written_opened_and_copied(mission, building, tmp_path):
    built = roomatlas.build(mission.log, tmp_path / "building.gpkg")
    assert [file.name for file in tmp_path.iterdir()] == ["building.gpkg"]
    opened = roomatlas.open(built.store)
    assert opened.plan.geojson() == building.plan.geojson()
    np.testing.assert_array_equal(opened.trajectory, building.trajectory)
    opened.save(tmp_path / "copy.gpkg")
    assert (tmp_path / "copy.gpkg").read_bytes() == built.store.read_bytes()


def test_building_again_gives_the_same_bytes(mission, building, tmp_path):
    built = roomatlas.build(mission.log, tmp_path / "building.gpkg", jobs=1)
    assert built.store.read_bytes() == building.store.read_bytes()


def test_parameters_are_those_of_the_command_line(mission, tmp_path):
    traced = roomatlas.build(mission.log, tmp_path / "traced.gpkg", plan="traced")
    with sqlite3.connect(traced.store) as store:
        text = store.execute("SELECT value FROM metadata WHERE key = 'configuration'"
                             ).fetchone()[0]
    assert 'plan="traced"' in text


def test_a_log_that_grows_while_it_is_mapped_is_refused(mission, tmp_path):
    log = tmp_path / "grows.clf"
    log.write_bytes(mission.log.read_bytes())
    store = tmp_path / "building.gpkg"

    def append(stage, share):
        with log.open("a") as file:
            file.write("# more\n")

    with pytest.raises(roomatlas.InputError, match="was written to while it was read"):
        roomatlas.build(log, store, progress=append)
    assert not store.exists()


def test_a_store_is_replaced_as_the_program_does_it(mission, building, tmp_path):
    place, real = tmp_path / "place.gpkg", tmp_path / "real.gpkg"
    place.symlink_to("real.gpkg")
    building.save(place)
    assert place.is_symlink()
    other = sqlite3.connect(real)
    other.execute("CREATE TABLE notes (note TEXT)")
    other.commit()
    building.save(place)
    assert place.is_symlink()
    assert (tmp_path / "real.former.gpkg").exists()
    other.close()
    with sqlite3.connect(real) as user:
        user.execute("PRAGMA journal_mode = WAL").fetchall()
        user.execute("SELECT count(*) FROM rooms").fetchall()
        for replace in (lambda: building.save(place), lambda: roomatlas.build(mission.log, place)):
            with pytest.raises(roomatlas.InputError, match="another program has it open"):
                replace()


def test_a_store_that_cannot_be_replaced_stays_where_it_is(building, tmp_path):
    place = building.store.with_name("place.gpkg")
    building.save(place)
    bytes_before = place.read_bytes()
    with pytest.raises(roomatlas.InputError, match="cannot be replaced"):
        roomatlas._core.replace_store(place, tmp_path / "missing.gpkg")
    assert place.read_bytes() == bytes_before
    assert [file.name for file in place.parent.glob("*former*")] == []
    place.unlink()


def test_a_temporary_store_goes_with_its_building(mission):
    building = roomatlas.build(mission.log)
    store = building.store
    assert store.exists()
    del building
    assert not store.parent.exists()
