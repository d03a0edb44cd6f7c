#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the worlds beside this file: python3 make_worlds.py [FOLDER]

A world is drawn on the centre lines of its walls: rooms are polygons that share edges, doors are
points on shared edges. What is written are the rooms as one sees them (inset by half a wall), the
openings, and as walls all that is left inside the building. Points are complex numbers, in metres.
"""

import cmath
import json
import math
import pathlib
import sys


def dot(a, b):
    return (a.conjugate() * b).real


def cross(a, b):
    return (a.conjugate() * b).imag


def edges(ring):
    return list(zip(ring, ring[1:] + ring[:1]))


def signed_area(ring):
    return sum(cross(p, q) for p, q in edges(ring)) / 2


def rounded(p):
    """To whole millimetres; adding 0.0 turns -0.0 into 0.0."""
    return complex(round(p.real, 3) + 0.0, round(p.imag, 3) + 0.0)


def polygon(*corners):
    return [complex(x, y) for x, y in corners]


def rectangle(x0, y0, x1, y1):
    return polygon((x0, y0), (x1, y0), (x1, y1), (x0, y1))


def inset(ring, distance):
    """A counter-clockwise ring moved inwards, corners mitred; outwards where negative."""
    moved = []
    for before, p, after in zip(ring[-1:] + ring[:-1], ring, ring[1:] + ring[:1]):
        u, v = (p - before) / abs(p - before), (after - p) / abs(after - p)
        moved.append(rounded(p + distance * 1j * (u + v) / (1 + dot(u, v))))
    return moved


def contains(ring, point):
    inside = False
    for p, q in edges(ring):
        if (p.imag > point.imag) != (q.imag > point.imag):
            share = (point.imag - p.imag) / (q.imag - p.imag)
            inside ^= point.real < p.real + share * (q.real - p.real)
    return inside


def distance_to_edge(p, q, point):
    share = dot(point - p, q - p) / abs(q - p) ** 2
    return abs(point - p - min(max(share, 0.0), 1.0) * (q - p))


def label_point(rings):
    """Of the points on a 0.25 m grid inside, the one farthest from the boundary, then from the ends."""
    xs, ys = [p.real for p in rings[0]], [p.imag for p in rings[0]]
    middle = complex(min(xs) + max(xs), min(ys) + max(ys)) / 2
    best, best_rank = None, (0.0, 0.0)
    for i in range(1, int(4 * (max(xs) - min(xs))) + 1):
        for j in range(1, int(4 * (max(ys) - min(ys))) + 1):
            point = rounded(complex(min(xs) + i / 4, min(ys) + j / 4))
            if sum(contains(ring, point) for ring in rings) != 1:
                continue
            clear_m = min(distance_to_edge(p, q, point) for ring in rings for p, q in edges(ring))
            rank = (round(clear_m, 3), -round(abs(point - middle), 3))
            if rank > best_rank:
                best, best_rank = point, rank
    return best


class World:
    def __init__(self, title, outline, thickness_m=0.2):
        self.title, self.half_m = title, thickness_m / 2
        self.outer = inset(outline, -self.half_m)
        self.rooms = []  # (kind, name, rings as one sees them)
        self.doors = []  # (room a, room b, two corners in a, two in b)
        self.courtyards = []
        self.furniture = []

    def room(self, name, ring, kind="room", pillars=()):
        """Returns the room's number. `pillars`: counter-clockwise rings inside it."""
        self.rooms.append((kind, name, [inset(ring, self.half_m)] + [p[::-1] for p in pillars]))
        return len(self.rooms)

    def corridor(self, name, ring):
        return self.room(name, ring, "corridor")

    def courtyard(self, ring):
        """Open air: neither room nor wall, and nothing leads there."""
        self.courtyards.append(inset(ring, self.half_m))

    def box(self, x0, y0, x1, y1):
        self.furniture.append([rounded(p) for p in rectangle(x0, y0, x1, y1)])

    def _opening(self, room, at, width_m):
        """The two corners in a room's outline, in the outline's direction.

        Rounded to millimetres they may lie beside a slanted wall; the outline then goes through them."""
        outline = self.rooms[room - 1][2][0]
        p, q = min(edges(outline), key=lambda e: distance_to_edge(*e, at))
        u = (q - p) / abs(q - p)
        along_m = dot(at - p, u)
        assert abs(cross(u, at - p)) < 0.2, f"{self.title}: no wall of room {room} at {at}"
        assert width_m / 2 < along_m < abs(q - p) - width_m / 2, f"{self.title}: door in a corner, {at}"
        corners = [rounded(p + u * (along_m + side * width_m / 2)) for side in (-1, 1)]
        behind = outline.index(p) + 1
        outline[behind:behind] = [c for c in corners if abs(cross(u, c - p)) > 1e-6]
        return corners

    def door(self, a, b, x, y, width_m=0.9):
        a, b, at = min(a, b), max(a, b), complex(x, y)
        self.doors.append((a, b, self._opening(a, at, width_m), self._opening(b, at, width_m)))

    def _free_space_rings(self):
        """Follows the rooms' outlines, and through the doors into the next room."""
        after = {}
        for number, (_, _, rings) in enumerate(self.rooms, 1):
            corners = [c for a, b, in_a, in_b in self.doors for r, c in ((a, in_a), (b, in_b)) if r == number]
            for index, ring in enumerate(rings):
                for p, q in edges(ring):
                    here = [c for c in corners if index == 0 and distance_to_edge(p, q, c[0]) < 0.002
                            and distance_to_edge(p, q, c[1]) < 0.002]
                    for first, second in sorted(here, key=lambda c: abs(c[0] - p)):
                        after[p] = first
                        p = second
                    if p != q:
                        after[p] = q
        for _, _, in_a, in_b in self.doors:
            after[in_a[0]], after[in_b[0]] = in_b[1], in_a[1]
        rings = []
        while after:
            ring = [next(iter(after))]
            while after[ring[-1]] != ring[0]:
                ring.append(after.pop(ring[-1]))
            after.pop(ring[-1])
            rings.append(ring)
        return rings

    def walls(self):
        """Bodies with their holes: a hole belongs to the smallest body around it."""
        rings = self._free_space_rings()
        bodies = [[self.outer]] + [[r[::-1]] for r in rings if signed_area(r) < 0]
        bodies.sort(key=lambda body: signed_area(body[0]))
        for hole in [r for r in rings if signed_area(r) > 0] + self.courtyards:
            around = next(body for body in bodies if contains(body[0], hole[0]))
            around.append(hole[::-1])
        return bodies[::-1]

    def features(self):
        for number, (kind, name, rings) in enumerate(self.rooms, 1):
            area_m2 = round(sum(signed_area(ring) for ring in rings), 3)
            yield feature(rings, kind=kind, id=number, name=name, area_m2=area_m2, label=position(label_point(rings)),
                          asrs=[], indoor="area" if kind == "hall" else kind, ref=str(number))
        for number, (a, b, in_a, in_b) in enumerate(self.doors, 1):
            jambs = [rounded((in_a[0] + in_b[1]) / 2), rounded((in_a[1] + in_b[0]) / 2)]
            yield feature([[in_a[1], in_a[0], in_b[1], in_b[0]]], kind="door", id=number,
                          width_m=round(abs(jambs[1] - jambs[0]), 3), jambs=[position(p) for p in jambs],
                          rooms=[a, b], indoor="door", ref=str(number))
        for body in self.walls():
            yield feature(body, kind="wall", indoor="wall")
        for box in self.furniture:
            yield feature([box], kind="furniture")

    def text(self):
        header = {"schema": "plan", "version": 1, "units": "m",
                  "frame": "local building metres, not longitude/latitude", "title": self.title}
        lines = ",\n".join(compact(each) for each in self.features())
        return f'{{"type":"FeatureCollection",\n"roomatlas":{compact(header)},\n"features":[\n{lines}\n]}}\n'


def position(p):
    return [p.real, p.imag]


def feature(rings, **properties):
    closed = [[position(p) for p in ring + ring[:1]] for ring in rings]
    return {"type": "Feature", "properties": properties, "geometry": {"type": "Polygon", "coordinates": closed}}


def compact(value):
    return json.dumps(value, separators=(",", ":"), ensure_ascii=False)


def two_rooms():
    """Two rooms joined by a door, after the paper's Fig. 1."""
    world = World("Two rooms", polygon((0, 0), (9.5, 0), (9.5, 6), (5, 6), (5, 4.5), (0, 4.5)))
    west = world.room("West room", rectangle(0, 0, 5, 4.5))
    east = world.room("East room", rectangle(5, 0, 9.5, 6))
    world.door(west, east, 5, 2.2)
    return world


def nine_rooms():
    """Nine places, two loops, rooms 5 and 6 joined by a door, after the paper's Fig. 8 and 9."""
    world = World("Nine rooms", rectangle(0, 0, 26, 14))
    world.room("1", rectangle(0, 0, 6, 5.8))
    world.room("2", rectangle(6, 0, 11, 5.8))
    world.room("3", polygon((11, 0), (20, 0), (20, 5.8), (14.5, 5.8), (14.5, 3.6), (11, 3.6)))
    world.corridor("4", polygon((0, 5.8), (11, 5.8), (11, 3.6), (14.5, 3.6), (14.5, 5.8), (20, 5.8), (20, 8), (0, 8)))
    world.room("5", rectangle(0, 8, 7, 14))
    world.room("6", rectangle(7, 8, 13, 14))
    world.room("7", rectangle(13, 8, 20, 14))
    world.room("8", rectangle(20, 0, 26, 7))
    world.room("9", rectangle(20, 7, 26, 14))
    for a, b, x, y in ((1, 4, 2.5, 5.8), (2, 4, 8.5, 5.8), (3, 4, 17.5, 5.8), (4, 5, 3, 8), (5, 6, 7, 10.5),
                       (6, 7, 13, 11.5), (4, 7, 16.5, 8), (7, 9, 20, 11), (8, 9, 23, 7), (3, 8, 20, 2.6)):
        world.door(a, b, x, y)
    world.box(0.1, 0.6, 0.7, 2.6)
    world.box(8.0, 0.1, 9.6, 0.7)
    world.box(15.0, 1.2, 16.8, 2.2)
    world.box(3.2, 13.3, 5.2, 13.9)
    world.box(9.4, 8.1, 10.8, 8.8)
    world.box(16.0, 10.6, 17.6, 11.6)
    world.box(25.2, 1.6, 25.9, 4.0)
    world.box(22.6, 10.4, 23.6, 12.0)
    return world


def afit_floor():
    """A floor of 78 m x 78 m: corridors in a figure of eight around two courtyards.

    The walls' centre lines reach from 0 to 77.8; with half a wall on either side it is 78 m.
    """
    end, west, east, south, north, width = 77.8, 7.4, 68.1, 8.0, 67.5, 2.3
    middle = 37.75
    world = World("A floor of 78 m x 78 m", rectangle(0, 0, end, end))
    in_west, in_south = west + width, south + width
    corridors = {
        "south": world.corridor("South corridor", rectangle(west, south, east + width, in_south)),
        "north": world.corridor("North corridor", rectangle(west, north, east + width, north + width)),
        "west": world.corridor("West corridor", rectangle(west, in_south, in_west, north)),
        "east": world.corridor("East corridor", rectangle(east, in_south, east + width, north)),
        "middle": world.corridor("Middle corridor", rectangle(in_west, middle, east, middle + width)),
    }
    for across, along in (("west", west + width / 2), ("east", east + width / 2)):
        world.door(corridors["south"], corridors[across], along, in_south, 1.0)
        world.door(corridors["north"], corridors[across], along, north, 1.0)
    world.door(corridors["west"], corridors["middle"], in_west, middle + width / 2, 1.0)
    world.door(corridors["east"], corridors["middle"], east, middle + width / 2, 1.0)

    def row(corridor, place, cuts, near, far, is_upright=False, first_number=0):
        """Rooms side by side along a corridor, each with a door to it; returns their numbers.

        `near`, `far`: the wall towards the corridor and the one opposite."""
        numbers = []
        for low, high in zip(cuts, cuts[1:]):
            name = str(first_number + len(numbers))
            sides = (low, min(near, far), high, max(near, far))
            if is_upright:
                sides = (sides[1], low, sides[3], high)
            numbers.append(world.room(name, rectangle(*sides)))
            # off the middle, now to one side, now to the other; inside the corridor's own length
            at = (low + high) / 2 + (1 if len(numbers) % 2 else -1) * (high - low) / 6
            at = min(max(at, place[0] + 1.2), place[1] - 1.2)
            world.door(numbers[-1], corridors[corridor], *((near, at) if is_upright else (at, near)),
                       (0.85, 0.9, 0.95)[len(world.doors) % 3])
        return numbers

    ends = (west, east + width)
    a = row("south", ends, [0, 11, 16.5, 22, 28, 38, 44, 53, 58.5, 66, end], south, 0, first_number=101)
    b = row("north", ends, [0, 10.5, 18, 24, 33.5, 36.5, 46, 52, 59, 67, end], north + width, end, first_number=201)
    sides = (in_south, north)
    c = row("west", sides, [south, 15, 20, 27.5, 35, 38, 46, 51.5, 59, north + width], west, 0, True, 301)
    d = row("east", sides, [south, 14, 22, 27, 36, 41, 49, 57, 62, north + width], east + width, end, True, 401)
    inner = (in_west, east)
    e = row("middle", inner, [in_west, 18, 26.5, 31, 41, 50, 58.5, east], middle, middle - 7.2, first_number=501)
    f = row("middle", inner, [in_west, 17, 27, 36.5, 40.5, 49, 60, east], middle + width, middle + width + 7.2,
            first_number=601)

    # rooms with two doors: into a neighbour, or to a second corridor
    world.door(a[1], a[2], 16.5, 3.5)
    world.door(a[6], a[7], 53, 4.5)
    world.door(b[2], b[3], 24, 74.5)
    world.door(c[3], c[4], 3.2, 35)
    world.door(d[5], d[6], 74.6, 49)
    world.door(e[3], e[4], 41, 33.5)
    world.door(e[0], corridors["west"], in_west, 33.6)
    world.door(e[-1], corridors["east"], east, 33.6)
    world.door(f[-1], corridors["east"], east, 44.2)
    world.door(f[1], f[2], 27, 44.6)

    world.courtyard(rectangle(in_west, in_south, east, middle - 7.2))
    world.courtyard(rectangle(in_west, middle + width + 7.2, east, north))

    for count, number in enumerate(a + b + c + d + e + f):
        furnish(world, number, count)
    return world


def furnish(world, number, count):
    """Every third room has a table in the middle, every third a cupboard in a corner free of doors."""
    ring = world.rooms[number - 1][2][0]
    low, high = min(ring, key=lambda p: p.real + p.imag), max(ring, key=lambda p: p.real + p.imag)
    middle = (low + high) / 2
    boxes = []
    if count % 3 == 0 and min((high - low).real, (high - low).imag) > 4.5:
        boxes = [(middle - 0.9 - 0.5j, middle + 0.9 + 0.5j)]
    if count % 3 == 1:
        boxes = [(low, low + 1.6 + 0.5j), (high - 1.6 - 0.5j, high)]
    openings = [c for a, b, in_a, in_b in world.doors for r, c in ((a, in_a), (b, in_b)) if r == number]
    for p, q in boxes:
        corners = rectangle(p.real, p.imag, q.real, q.imag)
        if min(distance_to_edge(s, t, c) for opening in openings for c in opening for s, t in edges(corners)) > 1.3:
            world.box(p.real, p.imag, q.real, q.imag)
            return


def identical_rooms():
    """Ten rooms that nothing tells apart, five on either side of a corridor."""
    world = World("Identical rooms", rectangle(0, 0, 25, 12.2))
    places = [(x, *sides) for sides in ((0, 5, 5), (7.2, 12.2, 7.2)) for x in range(0, 25, 5)]
    rooms = [world.room(str(i), rectangle(x, low, x + 5, high)) for i, (x, low, high, _) in enumerate(places, 1)]
    corridor = world.corridor("Corridor", rectangle(0, 5, 25, 7.2))
    for room, (x, _, _, wall) in zip(rooms, places):
        world.door(room, corridor, x + 2.5, wall)
    return world


def slanted_and_curved():
    """A slanted wall, an arc of 9 degree steps, and a wing at 30 degrees."""
    origin, turn = 21 + 0j, cmath.rect(1, math.radians(30))

    def wing(s0, t0, s1, t1):
        return [origin + turn * p for p in rectangle(s0, t0, s1, t1)]

    def wing_door(a, b, s, t):
        at = origin + turn * complex(s, t)
        world.door(a, b, at.real, at.imag)

    arc = [3.5 + 12.5j + cmath.rect(3.5, math.radians(angle)) for angle in range(0, 181, 9)]
    foyer = polygon((13, 0), (21, 0)) + [origin + turn * 12j] + polygon((13, (turn * 12j).imag))
    outline = polygon((0, 0), (21, 0)) + wing(0, 0, 14, 12)[1:] + [foyer[3]] + polygon((13, 12.5)) + arc
    world = World("Slanted and curved walls", outline)
    slanted = world.room("Slanted room", polygon((0, 0), (6, 0), (8, 6), (0, 6)))
    office = world.room("Office", polygon((6, 0), (13, 0), (13, 6), (8, 6)))
    corridor = world.corridor("Corridor", rectangle(0, 6, 13, 8.3))
    apse = world.room("Apse", polygon((0, 8.3), (7, 8.3)) + arc)
    studio = world.room("Studio", rectangle(7, 8.3, 13, 12.5))
    hall = world.room("Foyer", foyer, "hall")
    wing_corridor = world.corridor("Wing corridor", wing(0, 4.9, 14, 7.1))
    wings = [world.room(f"Wing {i}", wing(*sides)) for i, sides in enumerate(
        ((0, 0, 6, 4.9), (6, 0, 14, 4.9), (0, 7.1, 7, 12), (7, 7.1, 14, 12)), 1)]
    world.door(slanted, corridor, 3.5, 6)
    world.door(slanted, office, 7, 3)
    world.door(office, corridor, 10.5, 6)
    world.door(apse, corridor, 3.5, 8.3)
    world.door(studio, corridor, 10, 8.3)
    world.door(corridor, hall, 13, 7.1)
    wing_door(hall, wing_corridor, 0, 6)
    for room, s, t in zip(wings, (3, 10, 3.5, 10.5), (4.9, 4.9, 7.1, 7.1)):
        wing_door(room, wing_corridor, s, t)
    wing_door(wings[2], wings[3], 7, 9.8)
    return world


def open_hall():
    """One hall with pillars, and no doors at all."""
    pillars = [rectangle(x - 0.3, y - 0.3, x + 0.3, y + 0.3) for x in (4, 8, 12, 16) for y in (4.5, 10.5)]
    world = World("Open hall", rectangle(0, 0, 20.2, 15.2))
    world.room("Hall", rectangle(0, 0, 20.2, 15.2), "hall", pillars)
    return world


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    folder = folder if folder.is_dir() else folder.parent
    for make in (two_rooms, nine_rooms, afit_floor, identical_rooms, slanted_and_curved, open_hall):
        (folder / f"{make.__name__}.geojson").write_text(make().text(), encoding="utf-8")


if __name__ == "__main__":
    main()
