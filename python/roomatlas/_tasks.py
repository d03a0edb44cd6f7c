# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulated missions, pose graphs, and judging a map."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._building import Building
from ._building import open as open_building
from ._parameters import Progress, as_toml
from ._plan import File

#: from id, to id, (x_m, y_m, theta_rad) of `to` in the frame of `from`, and the 3 x 3 information.
Edge = tuple[int, int, Sequence[float], ArrayLike]


@dataclass(frozen=True)
class Mission:
    """A simulated mission's files."""

    log: Path
    truth_poses: Path  #: TUM
    truth_plan: Path  #: GeoJSON
    readings: int


def simulate(world: File, out: File, *, format: str = "clf", tour: bool = False,
             drive: Iterable[Sequence[float]] = (), progress: Progress = None,
             **parameters: Any) -> Mission:
    """Drives a robot through a world and writes the log with its truth into the folder `out`.

    `world` is a plan as GeoJSON or a nav2 map. The robot explores; with `tour` it is steered
    through all rooms, with `drive` along way-points (x, y in metres). `format` is "clf", "bag",
    "mcap" or "db3". Other keyword arguments are the simulator's parameters: `seed=2`,
    `sensor="laser"`, `odometry="typical"`.

    Raises InputError, UsageError, and KeyboardInterrupt on Ctrl-C.
    """
    points = [(float(x_m), float(y_m)) for x_m, y_m in drive]
    if tour and points:
        raise _core.UsageError("simulate: expected either drive or tour")
    folder = Path(out)
    readings = _core.simulate(Path(world), folder, format, tour, points, as_toml(parameters),
                              progress)
    return Mission(folder / f"mission.{format}", folder / "truth.tum", folder / "truth.geojson",
                   readings)


def evaluate(building: Union[Building, File], *truth: File, **parameters: Any) -> dict[str, Any]:
    """All figures of a building against files of truth, as `roomatlas evaluate --json` has them.

    `truth` are relations (.relations), plans (.geojson), room labels (.pgm), measured lengths
    (.csv) or trajectories. Without any, the map is judged by itself and by true poses of its log.
    """
    if not isinstance(building, Building):
        building = open_building(building)
    return building.evaluate(*truth, **parameters)


@dataclass(frozen=True, eq=False)
class Optimized:
    """A pose graph's solution."""

    ids: NDArray[np.int64]
    poses: NDArray[np.float64]  #: N x 3, in the order of `ids`: x_m, y_m, theta_rad
    trusted: bool  #: no warning speaks against the result
    converged: bool
    message: str
    iterations: int
    initial_chi_square: float
    chi_square: float  #: over the accepted edges
    expected_chi_square: tuple[float, float]  #: quantiles 0.0005 and 0.9995
    edges: list[dict[str, Any]]  #: source, target, is_loop, accepted, weight, chi_square, reason
    issues: list[str]

    @property
    def rejected(self) -> list[tuple[int, int]]:
        """The edges that were rejected."""
        return [(edge["source"], edge["target"]) for edge in self.edges if not edge["accepted"]]


def optimize(graph: Union[File, Iterable[Edge]], *, robust: bool = False) -> Optimized:
    """Solves a pose graph: a file (g2o, TORO), or edges.

    An edge is `(from, to, (x_m, y_m, theta_rad), information)` with ids of whole numbers and the
    3 x 3 inverse covariance of the measured pose. Ids that differ by 1 are joined by odometry, all
    others by loops. `robust` rejects loops that contradict odometry and each other.

    Raises InputError naming the line or edge at fault, NotEnoughError where there is no edge.
    """
    if isinstance(graph, (str, PathLike)):
        solved = _core.optimize_file(Path(graph), robust)
    else:
        solved = _core.optimize_edges(
            [(int(a), int(b), tuple(float(p) for p in pose), np.asarray(information, float))
             for a, b, pose, information in graph], robust)
    solved["ids"] = np.asarray(solved["ids"], dtype=np.int64)
    solved["poses"] = solved["poses"][:, 1:]
    return Optimized(**solved)
