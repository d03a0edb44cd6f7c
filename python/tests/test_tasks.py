# SPDX-License-Identifier: GPL-3.0-or-later
import struct
import zlib

import numpy as np
import pytest
import roomatlas


def three_rooms():
    grid = np.full((160, 240), 100)
    grid[4:76, 4:116] = 0
    grid[4:76, 124:236] = 0
    grid[84:156, 4:236] = 0
    grid[76:84, 50:68] = 0
    grid[76:84, 170:188] = 0
    return grid


def test_cells_become_rooms_of_the_size_that_was_painted():
    plan = roomatlas.segment(three_rooms(), resolution_m=0.05)
    painted_m2 = sorted([72 * 112 * 0.0025, 72 * 112 * 0.0025, 72 * 232 * 0.0025])
    assert sorted(room.area_m2 for room in plan.rooms) == pytest.approx(painted_m2, rel=0.03)
    assert sorted(len(list(plan.graph.neighbors(room.id))) for room in plan.rooms) == [1, 1, 2]
    assert [door.width_m for door in plan.doors] == pytest.approx([0.9, 0.9], abs=0.06)


def test_cells_lie_where_their_origin_says():
    here = roomatlas.segment(three_rooms(), resolution_m=0.05).rooms[0].label_point
    there = roomatlas.segment(three_rooms(), resolution_m=0.05,
                              origin=(10.0, -5.0, 0.0)).rooms[0].label_point
    assert np.subtract(there, here) == pytest.approx([10.0, -5.0], abs=0.06)


def test_a_picture_is_a_map_too(tmp_path):
    grid = np.flipud(three_rooms())
    pixels = np.where(grid == 100, 0, 254).astype(np.uint8)
    file = tmp_path / "map.pgm"
    file.write_bytes(b"P5\n%d %d\n255\n" % (grid.shape[1], grid.shape[0]) + pixels.tobytes())
    from_file = roomatlas.segment(file, resolution_m=0.05)
    from_cells = roomatlas.segment(three_rooms(), resolution_m=0.05)
    assert [r.area_m2 for r in from_file.rooms] == [r.area_m2 for r in from_cells.rooms]
    built = roomatlas.build(file, tmp_path / "building.gpkg", resolution_m=0.05)
    assert [r.area_m2 for r in built.rooms] == [r.area_m2 for r in from_cells.rooms]
    assert built.trajectory.shape == (0, 4)


def png_of(pixels):
    """A grey picture by the letter of the format, without any library of pictures."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(
            ">I", zlib.crc32(kind + data))

    height, width = pixels.shape
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def test_a_png_is_read_by_the_plug_in(tmp_path):
    pixels = np.where(np.flipud(three_rooms()) == 100, 0, 254).astype(np.uint8)
    file = tmp_path / "map.png"
    file.write_bytes(png_of(pixels))
    from_file = roomatlas.segment(file, resolution_m=0.05)
    from_cells = roomatlas.segment(three_rooms(), resolution_m=0.05)
    assert [r.area_m2 for r in from_file.rooms] == [r.area_m2 for r in from_cells.rooms]


def test_wrong_cells_are_said():
    with pytest.raises(roomatlas.UsageError, match="rows"):
        roomatlas.segment(np.zeros(5), resolution_m=0.05)
    with pytest.raises(roomatlas.UsageError, match="resolution_m"):
        roomatlas.segment(three_rooms())


def test_missions_are_the_same_for_the_same_seed(world, tmp_path):
    first = roomatlas.simulate(world, tmp_path / "1", tour=True, seed=5)
    again = roomatlas.simulate(world, tmp_path / "2", tour=True, seed=5)
    other = roomatlas.simulate(world, tmp_path / "3", tour=True, seed=6)
    assert first.log.read_bytes() == again.log.read_bytes() != other.log.read_bytes()
    assert len(first.truth_poses.read_text().splitlines()) == first.readings
    with pytest.raises(roomatlas.UsageError, match="tour"):
        roomatlas.simulate(world, tmp_path / "4", tour=True, drive=[(1.0, 1.0), (2.0, 1.0)])


def square(turn_rad):
    information = np.diag([100.0, 100.0, 1000.0])
    edges = [(k, k + 1, (10.0, 0.0, turn_rad), information) for k in range(8)]
    return edges + [(k, k + 4, (0.0, 0.0, 0.0), information) for k in range(5)]


def test_a_graph_is_solved_to_a_square():
    solution = roomatlas.optimize(square(np.radians(91.0)))
    assert solution.converged and solution.poses.shape == (9, 3)
    assert list(solution.ids) == list(range(9))
    sides = np.linalg.norm(np.diff(solution.poses[:, :2], axis=0), axis=1)
    assert sides == pytest.approx(np.full(8, 10.0), abs=0.1)
    assert np.linalg.norm(solution.poses[4, :2] - solution.poses[0, :2]) < 0.1


def test_a_false_loop_is_rejected():
    edges = square(np.radians(90.0)) + [(1, 6, (0.0, 0.0, 0.0), np.diag([100.0, 100.0, 1000.0]))]
    assert roomatlas.optimize(edges, robust=True).rejected == [(1, 6)]
    assert roomatlas.optimize(edges).rejected == []


def test_a_file_gives_what_its_edges_give(tmp_path):
    lines = ["EDGE_SE2 {} {} {} {} {!r} {} 0 0 {} 0 {}".format(
        a, b, *map(float, pose), i[0, 0], i[1, 1], i[2, 2])
        for a, b, pose, i in square(np.radians(91.0))]
    file = tmp_path / "graph.g2o"
    file.write_text("\n".join(lines).replace("np.float64(", "").replace(")", "") + "\n")
    np.testing.assert_allclose(roomatlas.optimize(file).poses,
                               roomatlas.optimize(square(np.radians(91.0))).poses, atol=1e-9)


def test_wrong_graphs_are_said():
    with pytest.raises(roomatlas.NotEnoughError):
        roomatlas.optimize([])
    with pytest.raises(roomatlas.InputError):
        roomatlas.optimize([(1, 1, (0.0, 0.0, 0.0), np.eye(3))])
