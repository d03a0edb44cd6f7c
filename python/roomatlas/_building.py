# SPDX-License-Identifier: GPL-3.0-or-later
"""Buildings: what a mission was made into, and the store that holds it."""

from __future__ import annotations

import json
import shutil
import tempfile
import weakref
from functools import cached_property
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._parameters import Progress, as_toml
from ._plan import Door, File, Plan, Room

if TYPE_CHECKING:
    import networkx


class Building:
    """A mapped mission. Made by `build` and `open`; in a notebook it shows itself."""

    def __init__(self, store: Path) -> None:
        self._store = store
        self._core = _core.read_building(store)

    @property
    def store(self) -> Path:
        """The GeoPackage behind it; a temporary one where `build` was given no name."""
        return self._store

    @cached_property
    def plan(self) -> Plan:
        """The floor plan."""
        return Plan(self._core.plan)

    @property
    def rooms(self) -> list[Room]:
        """All rooms, by their ids."""
        return self.plan.rooms

    @property
    def doors(self) -> list[Door]:
        """All doors, by their ids."""
        return self.plan.doors

    @property
    def graph(self) -> "networkx.MultiGraph":
        """Rooms and the doors between them, for networkx; see `Plan.graph`."""
        return self.plan.graph

    @cached_property
    def trajectory(self) -> NDArray[np.float64]:
        """The robot's corrected poses, one a reading, N x 4: timestamp_s, x_m, y_m, theta_rad."""
        return self._core.trajectory

    @cached_property
    def odometry(self) -> NDArray[np.float64]:
        """The same poses as odometry had them, in odometry's own frame; rows as in `trajectory`."""
        return self._core.odometry

    def evo_trajectory(self) -> Any:
        """The trajectory as evo's `PoseTrajectory3D`. Needs the package evo."""
        from evo.core.trajectory import PoseTrajectory3D

        path = self.trajectory
        flat = np.zeros(len(path))
        half_rad = path[:, 3] / 2
        return PoseTrajectory3D(
            positions_xyz=np.column_stack([path[:, 1:3], flat]),
            orientations_quat_wxyz=np.column_stack([np.cos(half_rad), flat, flat,
                                                    np.sin(half_rad)]),
            timestamps=path[:, 0])

    @cached_property
    def judgement(self) -> Optional[dict[str, Any]]:
        """How far the map can be relied on, and why; None where it could not be judged."""
        text = self._core.judgement
        return None if text is None else json.loads(text)

    @property
    def probability(self) -> Optional[float]:
        """That the map is right, in [0, 1]; None where it could not be judged."""
        return None if self.judgement is None else self.judgement["probability"]

    def evaluate(self, *truth: File, **parameters: Any) -> dict[str, Any]:
        """Errors against files of truth; see `roomatlas.evaluate`."""
        files = [Path(file) for file in truth]
        return json.loads(_core.evaluate(self._store, files, as_toml(parameters)))

    def save(self, file: File) -> None:
        """Copies the store: a GeoPackage that QGIS, the program and `open` read.

        A store that is there is replaced as `build` replaces one.
        """
        path = Path(file)
        if path.suffix != ".gpkg":
            raise _core.UsageError(f"{path}: expected a name that ends in .gpkg; `plan.save` "
                                   "writes drawings")
        _core.copy_store(self._store, path)

    def _repr_html_(self) -> str:
        odds = "" if self.probability is None else (
            f", right with a probability of {min(99.0, 100 * self.probability):.0f} %")
        return (f"<p><b>{escape(self.plan.title)}</b>: {self.plan.counts}{odds}</p>"
                f"{self._page()}")

    def _page(self) -> str:
        svg = self.plan.svg()
        page = svg[svg.index("<svg"):]
        return page.replace("<svg", '<svg style="max-width:100%;height:auto"', 1)  # fits its cell

    def __repr__(self) -> str:
        return f"<roomatlas.Building {self.plan.title!r}: {self.plan.counts}>"


def open(file: File) -> Building:
    """The building in a store that `build` or the program has made.

    Raises InputError where the file is missing or no store, NotEnoughError where it is not
    assembled yet.
    """
    return Building(Path(file))


def build(log: File, store: Optional[File] = None, *, resolution_m: float = 0.0, jobs: int = 0,
          progress: Progress = None, **parameters: Any) -> Building:
    """Maps a mission's log, or a finished map, to a building.

    `log` is any that the program reads, told by its content. `store` is the GeoPackage to write;
    without one it is temporary and goes with the building. One that is there is replaced when all
    went well; its rooms keep their numbers and names where it is of the same log. One of another log
    in which something is named, corrected or added by other programs, and one that cannot be read,
    stay beside as `NAME.former.gpkg`. `resolution_m` is of a bare picture, metres a pixel.
    `progress(stage, share)` is called up to 20 times a second.
    Other keyword arguments are the parameters of the command line (`roomatlas config --print`) with
    `_` for `-`: `plan="traced"`, `cell=0.05`. `jobs` threads work at once, 0: one a core; the
    result is the same.

    Raises InputError, NotEnoughError, UsageError, and KeyboardInterrupt on Ctrl-C.
    """
    place = None if store is None else Path(store)
    if place is not None and place.exists() and place.samefile(log):
        raise _core.UsageError(f"{place}: is the log itself, expected another file for the store")
    lock = None if place is None else _core.PlaceLock(place, [Path(log)])  # until this returns
    folder = tempfile.mkdtemp(prefix="roomatlas-", dir=None if place is None else place.parent)
    made = Path(folder) / "building.gpkg"
    try:
        _core.build(Path(log), made, place or made, resolution_m, as_toml(parameters), jobs,
                    progress)
        if place is not None:
            _core.replace_store(place, made)
            shutil.rmtree(folder)
            return Building(place)
        building = Building(made)
    except BaseException:
        shutil.rmtree(folder, ignore_errors=True)
        raise
    finally:
        del lock
    weakref.finalize(building, shutil.rmtree, folder, ignore_errors=True)
    return building
