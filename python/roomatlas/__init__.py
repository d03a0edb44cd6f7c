# SPDX-License-Identifier: GPL-3.0-or-later
"""From a finished robot mission to a building map that a person can read.

    import roomatlas

    building = roomatlas.build("log.bag")
    for room in building.rooms:
        print(room.name, room.kind, room.area_m2)
    building.plan.save("plan.svg")

Lengths are metres in the building's frame, angles radians, times seconds; names say so (`_m`,
`_rad`, `_s`). What is wrong is raised: `UsageError`, `InputError`, `NotEnoughError`, all of them
`roomatlas.Error`. Long work releases Python's lock and stops for Ctrl-C (`KeyboardInterrupt`).
"""

from ._building import Building, build, open
from ._core import Error, InputError, Interrupted, NotEnoughError, UsageError, __version__
from ._plan import Door, Furniture, Plan, Room, segment
from ._tasks import Mission, Optimized, evaluate, optimize, simulate

__all__ = [
    "Building", "Door", "Error", "Furniture", "InputError", "Interrupted", "Mission",
    "NotEnoughError", "Optimized", "Plan", "Room", "UsageError", "__version__", "build",
    "evaluate", "open", "optimize", "segment", "simulate",
]
