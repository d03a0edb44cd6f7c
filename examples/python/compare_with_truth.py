# SPDX-License-Identifier: GPL-3.0-or-later
"""What correcting a mission brings, over worse and worse odometry: compare_with_truth.py WORLD OUT"""

# %% The same building driven through with three kinds of odometry
import sys
from pathlib import Path

import numpy as np
import roomatlas

world, out = Path(sys.argv[1]), Path(sys.argv[2])
for odometry in ("mild", "typical", "hard"):
    mission = roomatlas.simulate(world, out / odometry, odometry=odometry, seed=3)
    building = roomatlas.build(mission.log)
    figures = building.evaluate(mission.truth_poses, mission.truth_plan)

    truth = np.loadtxt(mission.truth_poses)[:, 1:3]
    driven_m = np.linalg.norm(np.diff(truth, axis=0), axis=1).sum()
    print(f"{odometry}: {len(building.trajectory)} poses over {driven_m:.0f} m, "
          f"{len(building.rooms)} rooms")

    # %% Errors, as `roomatlas evaluate --json` has them
    poses = figures["true_poses"]
    for when in ("before", "after"):
        print(f"  {when} the correction: {poses[when]['fitted_position_m']['mean']:.3f} m off")
