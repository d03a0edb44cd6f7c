# SPDX-License-Identifier: GPL-3.0-or-later
"""What other programs' readers make of the files that `export` writes, as JSON.

Read by PyYAML, Pillow, NumPy, Shapely, NetworkX and Python's own csv and json; nothing of
Roomatlas is used. Usage: read_exports.py FOLDER READER...
"""

import csv
import json
import math
import pathlib
import sys

import networkx
import numpy
import yaml
from PIL import Image
from shapely.geometry import LineString, Point, Polygon
from shapely.ops import unary_union


def read_rooms_yaml(folder):
    """Rooms' areas (m2), the largest difference of an area from its polygons', goals inside."""
    rooms = yaml.safe_load((folder / "rooms.yaml").read_text())["rooms"]
    floors = {r["id"]: unary_union([Polygon(p) for p in r["polygons"]]) for r in rooms}
    return rooms, floors


def rooms_yaml(folder):
    rooms, floors = read_rooms_yaml(folder)
    return {
        "names": [r["name"] for r in rooms],
        "areas_m2": [r["area_m2"] for r in rooms],
        "outlines_m2": [floors[r["id"]].area for r in rooms],
        "goals_inside": sum(floors[r["id"]].contains(Point(r["goal"])) for r in rooms),
    }


def rooms_csv(folder):
    with open(folder / "rooms.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    return {"names": [r["name"] for r in rows], "areas_m2": [float(r["area_m2"]) for r in rows]}


def map_yaml(folder):
    """What map_server makes of the picture: cells free, occupied and unknown, and the share of the
    free cells' centres that lie in rooms of rooms.yaml."""
    about = yaml.safe_load((folder / "map.yaml").read_text())
    shade = numpy.asarray(Image.open(folder / about["image"]), dtype=float)
    occupied = shade / 255.0 if about["negate"] else (255.0 - shade) / 255.0
    is_free = occupied < about["free_thresh"]
    rows, columns = numpy.nonzero(is_free)
    cell_m = about["resolution"]
    x_m = about["origin"][0] + (columns + 0.5) * cell_m
    y_m = about["origin"][1] + (shade.shape[0] - rows - 0.5) * cell_m
    floor = unary_union([f.buffer(0.3) for f in read_rooms_yaml(folder)[1].values()])
    some = range(0, len(x_m), max(1, len(x_m) // 2000))
    inside = sum(floor.contains(Point(x_m[i], y_m[i])) for i in some)
    return {
        "free_m2": float(is_free.sum()) * cell_m**2,
        "occupied_m2": float((occupied > about["occupied_thresh"]).sum()) * cell_m**2,
        "inside": inside / len(some),
    }


def building_yaml(folder):
    """Doors' lengths, floors' areas, and whether each reference is to a vertex that is there."""
    level = yaml.safe_load((folder / "building.yaml").read_text())["levels"]["L1"]
    vertices = level["vertices"]
    used = [i for kind in ("walls", "doors", "lanes") for item in level[kind] for i in item[:2]]
    used += [i for floor in level["floors"] for i in floor["vertices"]]

    def at(index):
        return vertices[index][:2]

    return {
        "references_hold": all(0 <= i < len(vertices) for i in used),
        "doors_m": [math.dist(at(d[0]), at(d[1])) for d in level["doors"]],
        "floors_m2": [Polygon([at(i) for i in f["vertices"]]).area for f in level["floors"]],
        "walls": len(level["walls"]),
        "lanes": len(level["lanes"]),
        "names": sorted(v[3] for v in vertices if len(v) > 3 and v[3]),
    }


def route_graph(folder):
    """The graph as NetworkX builds it; edges must join nodes, and end where these lie."""
    graph = networkx.DiGraph()
    lines = []
    for feature in json.loads((folder / "route_graph.geojson").read_text())["features"]:
        about = feature["properties"]
        if feature["geometry"]["type"] == "Point":
            graph.add_node(about["id"], at=feature["geometry"]["coordinates"])
        else:
            lines.append((about, feature["geometry"]["coordinates"]))
    rooms = [f for f in read_rooms_yaml(folder)[1].values()]
    floor = unary_union([f.buffer(0.15) for f in rooms])
    off_m = 0.0
    beyond_m = 0.0
    for about, path in lines:
        for leg in path:
            points = LineString(leg)
            graph.add_edge(about["startid"], about["endid"])
            off_m = max(off_m, math.dist(leg[0], graph.nodes[about["startid"]]["at"]),
                        math.dist(leg[-1], graph.nodes[about["endid"]]["at"]))
            beyond_m += points.difference(floor).length
    return {
        "nodes": graph.number_of_nodes(),
        "edges": graph.number_of_edges(),
        "all_have_places": all("at" in graph.nodes[n] for n in graph),
        "parts": networkx.number_weakly_connected_components(graph),
        "off_m": off_m,
        "beyond_m": beyond_m,
    }


def graph_g2o(folder):
    """Chi-square of the edges at the vertices, by the definition."""
    pose = {}
    chi2 = 0.0
    edges = 0
    for line in (folder / "graph.g2o").read_text().splitlines():
        word = line.split()
        if word[0] == "VERTEX_SE2":
            pose[int(word[1])] = numpy.array([float(w) for w in word[2:5]])
    for line in (folder / "graph.g2o").read_text().splitlines():
        word = line.split()
        if word[0] != "EDGE_SE2":
            continue
        a, b = pose[int(word[1])], pose[int(word[2])]
        measured = numpy.array([float(w) for w in word[3:6]])
        c, s = math.cos(a[2]), math.sin(a[2])
        way = numpy.array([[c, s], [-s, c]]) @ (b[:2] - a[:2]) - measured[:2]
        c, s = math.cos(measured[2]), math.sin(measured[2])
        turn = b[2] - a[2] - measured[2]
        error = numpy.append(numpy.array([[c, s], [-s, c]]) @ way,
                             math.atan2(math.sin(turn), math.cos(turn)))
        i = [float(w) for w in word[6:12]]
        information = numpy.array([[i[0], i[1], i[2]], [i[1], i[3], i[4]], [i[2], i[4], i[5]]])
        chi2 += float(error @ information @ error)
        edges += 1
    return {"vertices": len(pose), "edges": edges, "chi2": chi2}


def trajectory(folder):
    rows = numpy.loadtxt(folder / "trajectory_corrected.tum", ndmin=2)
    length = numpy.linalg.norm(rows[:, 4:8], axis=1)
    return {
        "poses": len(rows),
        "columns": rows.shape[1],
        "in_order": bool((numpy.diff(rows[:, 0]) >= 0).all()),
        "unit_off": float(abs(length - 1.0).max()),
    }


def pictures(folder):
    told = {}
    for name in ("plan.png", "before_after.png"):
        if (folder / name).exists():
            picture = Image.open(folder / name)
            picture.load()
            told[name] = {"width": picture.width, "shades": len(set(picture.convert("L").getdata()))}
    return told


READERS = {
    reader.__name__: reader
    for reader in (rooms_yaml, rooms_csv, map_yaml, building_yaml, route_graph, graph_g2o,
                   trajectory, pictures)
}


def main():
    folder = pathlib.Path(sys.argv[1])
    print(json.dumps({name: READERS[name](folder) for name in sys.argv[2:]}))


if __name__ == "__main__":
    main()
