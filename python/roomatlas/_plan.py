# SPDX-License-Identifier: GPL-3.0-or-later
"""Plans: rooms, doors, walls; drawn, as a graph, as data."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._parameters import Progress, as_toml

if TYPE_CHECKING:
    import networkx
    import shapely.geometry

#: A polygon without Shapely: the outer ring, N x 2, and the rings of its holes.
Rings = tuple[NDArray[np.float64], list[NDArray[np.float64]]]
File = Union[str, "PathLike[str]"]


def _shapely() -> Any:
    try:
        import shapely.geometry
    except ImportError as missing:
        raise ImportError("polygons need Shapely (python3-shapely); `rings` and `jambs` do "
                          "without it") from missing
    return shapely.geometry


@dataclass(frozen=True, eq=False)
class Room:
    """A room of the plan."""

    id: int  #: 1, 2, 3 ...
    name: str  #: its number where nobody named it
    kind: str  #: "room", "corridor" or "hall"
    area_m2: float
    rings: list[Rings]  #: its parts, metres; usually one, the largest first
    label_point: tuple[float, float]  #: well inside the largest part, metres
    visits: list[int]  #: of the robot, from 1; empty in a plan without a mission

    @cached_property
    def polygon(self) -> "shapely.geometry.Polygon | shapely.geometry.MultiPolygon":
        """The room's floor for Shapely, metres; a MultiPolygon where it has several parts."""
        geometry = _shapely()
        parts = [geometry.Polygon(outer, holes) for outer, holes in self.rings]
        return parts[0] if len(parts) == 1 else geometry.MultiPolygon(parts)


@dataclass(frozen=True, eq=False)
class Door:
    """A door of the plan."""

    id: int  #: 1, 2, 3 ...
    kind: str  #: "door", "passage" (wider) or "window" (never driven through)
    width_m: float  #: jamb to jamb
    jambs: NDArray[np.float64]  #: 2 x 2, metres: the two ends of the door's line
    opening: NDArray[np.float64]  #: 4 x 2, metres: the hole in the wall
    leaf: Optional[NDArray[np.float64]]  #: 2 x 2, hinge and end, where it was seen open
    rooms: tuple[Optional[int], Optional[int]]  #: ids on its two sides, where known

    @cached_property
    def line(self) -> "shapely.geometry.LineString":
        """The door's line for Shapely, jamb to jamb, metres."""
        return _shapely().LineString(self.jambs)


@dataclass(frozen=True, eq=False)
class Furniture:
    """An obstacle that is no wall."""

    kind: str  #: "against wall" or "free standing", as the exports name them
    rings: Rings


class Plan:
    """A floor plan; in a notebook it shows itself."""

    def __init__(self, core: _core.Plan) -> None:
        self._core = core

    @property
    def title(self) -> str:
        """The mission's or map's name."""
        return self._core.title

    @cached_property
    def rooms(self) -> list[Room]:
        """All rooms, by their ids."""
        return [Room(r["id"], r["name"], r["kind"], r["area_m2"], r["parts"],
                     tuple(r["label_point"][0].tolist()), r["visits"])
                for r in self._core.rooms]

    @cached_property
    def doors(self) -> list[Door]:
        """All doors, by their ids."""
        return [Door(d["id"], d["kind"], d["width_m"], d["jambs"], d["opening"], d["leaf"],
                     (d["room_a"], d["room_b"]))
                for d in self._core.doors]

    @cached_property
    def furniture(self) -> list[Furniture]:
        """Obstacles that are no walls."""
        return [Furniture(kind, rings) for kind, rings in self._core.furniture]

    @cached_property
    def wall_rings(self) -> list[Rings]:
        """Bodies of the walls as rings, metres."""
        return self._core.walls

    @cached_property
    def walls(self) -> "shapely.geometry.MultiPolygon":
        """Bodies of the walls for Shapely, metres; doors are gaps in them."""
        return _shapely().MultiPolygon(self.wall_rings)

    @property
    def counts(self) -> str:
        """How many rooms and doors there are, in words."""
        return (f"{len(self.rooms)} room{'' if len(self.rooms) == 1 else 's'}, "
                f"{len(self.doors)} door{'' if len(self.doors) == 1 else 's'}")

    @property
    def issues(self) -> list[str]:
        """What was imperfect in the data and did not stop the work."""
        return self._core.issues

    @cached_property
    def graph(self) -> "networkx.MultiGraph":
        """Rooms and the doors between them, for networkx.

        Nodes are rooms' ids with `room`, `name`, `kind`, `area_m2` and `pos` (x, y in metres);
        edges are doors, their keys the doors' ids, with `door`, `kind`, `width_m` and `length_m`,
        which is the way from one room's label through the door to the other's. Doors that lead out
        of what is known are no edges.
        """
        import networkx

        graph = networkx.MultiGraph(name=self.title)
        for room in self.rooms:
            graph.add_node(room.id, room=room, name=room.name, kind=room.kind,
                           area_m2=room.area_m2, pos=room.label_point)
        for door in self.doors:
            a, b = door.rooms
            if a is None or b is None:
                continue
            middle = door.jambs.mean(axis=0)
            length_m = sum(float(np.linalg.norm(middle - graph.nodes[room]["pos"]))
                           for room in (a, b))
            graph.add_edge(a, b, key=door.id, door=door, kind=door.kind, width_m=door.width_m,
                           length_m=length_m)
        return graph

    def room(self, name_or_id: Union[str, int]) -> Room:
        """The room of that name or id. Raises KeyError naming those that there are."""
        for room in self.rooms:
            if name_or_id in (room.id, room.name):
                return room
        names = ", ".join(room.name for room in self.rooms)
        raise KeyError(f"no room {name_or_id!r}; there are: {names}")

    def svg(self, *, trajectory: bool = False, room_graph: bool = False,
            north_deg: Optional[float] = None) -> str:
        """The drawing as an SVG page at a round scale.

        `north_deg` says where north is, clockwise from the building's y axis.
        """
        return self._core.svg(trajectory, room_graph, north_deg)

    def geojson(self) -> dict[str, Any]:
        """The plan as GeoJSON in local metres."""
        return json.loads(self._core.geojson())

    def save(self, file: File) -> None:
        """Writes the plan as its ending says: `.svg`, `.geojson` or `.json`."""
        path = Path(file)
        if path.suffix == ".svg":
            path.write_text(self.svg(), encoding="utf-8")
        elif path.suffix in (".geojson", ".json"):
            path.write_text(self._core.geojson(), encoding="utf-8")
        else:
            raise _core.UsageError(f"{path}: expected a name that ends in .svg, .geojson or .json; "
                                   "`roomatlas export` writes the other formats")

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        return f"<roomatlas.Plan {self.title!r}: {self.counts}>"


def segment(map: Union[File, ArrayLike], *, resolution_m: float = 0.0,
            origin: tuple[float, float, float] = (0.0, 0.0, 0.0), progress: Progress = None,
            **parameters: Any) -> Plan:
    """Rooms and doors of a finished map.

    `map` is a nav2 map (YAML), a picture (with its `resolution_m`, metres a pixel), or an array of
    cells as ROS's OccupancyGrid has them: -1 unknown, 0 to 25 free, 65 to 100 occupied, the first
    row lowest. `origin` is where an array's lower left corner lies: x_m, y_m, theta_rad. Other
    keyword arguments are parameters of the command line.

    Raises InputError for what cannot be read, UsageError where the resolution is missing, and
    NotEnoughError where no cell of a file is free.
    """
    if isinstance(map, (str, PathLike)):
        core = _core.segment_file(Path(map), resolution_m, as_toml(parameters), progress)
    else:
        cells = np.ascontiguousarray(map, dtype=np.intc)
        core = _core.segment_cells(cells, resolution_m, origin, as_toml(parameters), progress)
    return Plan(core)
