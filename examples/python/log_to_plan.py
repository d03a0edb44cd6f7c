# SPDX-License-Identifier: GPL-3.0-or-later
"""From a robot's log to rooms, a plan and the ways between rooms: log_to_plan.py WORLD OUT

The log here is simulated; any of a real robot does: CARMEN, ROS bag, MCAP. Cells (# %%) are those of
a notebook: in Jupyter a `building` or a `plan` shows itself.
"""

# %% A log
import sys
from pathlib import Path

import networkx
import roomatlas

world, out = Path(sys.argv[1]), Path(sys.argv[2])
mission = roomatlas.simulate(world, out, odometry="typical")

# %% The building, kept in a file that QGIS opens too
building = roomatlas.build(mission.log, out / "building.gpkg")
print(building)
print(f"right with a probability of {building.probability:.2f}")

# %% Its rooms and doors
for room in building.rooms:
    print(f"{room.kind} {room.name}: {room.area_m2:.1f} m2, {len(room.visits)} visits, "
          f"convex hull {room.polygon.convex_hull.area:.1f} m2")
for door in building.doors:
    print(f"{door.kind} {door.id}: {door.width_m:.2f} m, between rooms {door.rooms}")

# %% The shortest way between two rooms
graph = building.graph
first, last = building.rooms[0].id, building.rooms[-1].id
if networkx.has_path(graph, first, last):
    way = networkx.shortest_path(graph, first, last, weight="length_m")
    print("way:", " to ".join(graph.nodes[room]["name"] for room in way))

# %% Where the robot drove
path = building.trajectory
print(f"{len(path)} poses over {path[-1, 0] - path[0, 0]:.0f} s")

# %% The plan
building.plan.save(out / "plan.svg")
building.plan.save(out / "plan.geojson")
