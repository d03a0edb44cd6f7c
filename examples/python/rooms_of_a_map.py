# SPDX-License-Identifier: GPL-3.0-or-later
"""Rooms of a finished occupancy grid, as any SLAM program leaves one: rooms_of_a_map.py WORLD OUT

The grid here is painted from a plan: three rooms of a building, 5 cm a cell. Then a pose graph of
one's own.
"""

# %% A grid as ROS has it: -1 unknown, 0 free, 100 occupied, the first row lowest
import sys
from pathlib import Path

import numpy as np
import roomatlas

out = Path(sys.argv[2])
out.mkdir(parents=True, exist_ok=True)
grid = np.full((160, 240), 100)
grid[4:76, 4:116] = 0  # two rooms below, a hall above
grid[4:76, 124:236] = 0
grid[84:156, 4:236] = 0
grid[76:84, 50:68] = 0  # their doors, 0.9 m wide
grid[76:84, 170:188] = 0

# %% Rooms and doors
plan = roomatlas.segment(grid, resolution_m=0.05)
print(plan)
for room in plan.rooms:
    print(f"room {room.name}: {room.area_m2:.1f} m2, doors to "
          f"{sorted(plan.graph.neighbors(room.id))}")
plan.save(out / "plan.svg")

# %% A robot drives twice round a block and knows its corners again, once wrongly
information = np.diag([100.0, 100.0, np.radians(2.0) ** -2])
turn_rad = np.radians(91.5)  # odometry turns too far
edges = [(k, k + 1, (20.0 if k % 2 == 0 else 10.0, 0.0, turn_rad), information) for k in range(8)]
edges += [(k, k + 4, (0.0, 0.0, 0.0), information) for k in range(5)]
edges += [(1, 6, (0.0, 0.0, 0.0), information)]
solution = roomatlas.optimize(edges, robust=True)
print(f"chi-square {solution.chi_square:.2f}, rejected: {solution.rejected}")
