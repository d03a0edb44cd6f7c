// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace roomatlas::io {

/// The turn in a stretch of a mission, as three who measured it say.
struct TurnedStretch {
  double passed_s = 0.0;
  double by_sweeps_rad = 0.0;
  double by_odometry_rad = 0.0;
  Eigen::Vector3d by_gyro_rad = Eigen::Vector3d::Zero();  ///< about its axes, drift and all
  bool stands = false;                                    ///< sweeps and odometry agree in that
};

/// What speaks for a gyro's turns, and against odometry's.
struct GyroVerdict {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< the robot's vertical, in the gyro's axes
  double drift_rad_per_s = 0.0;                   ///< about it
  int stretches = 0;                              ///< with turns that could be compared
  double turned_rad = 0.0;                        ///< in all of these
  double gyro_off_rad = 0.0;                      ///< from the sweeps, root mean square
  double odometry_off_rad = 0.0;
  bool is_enough = false;       ///< to tell which is better
  bool gyro_is_better = false;  ///< clearly
};

/// Compares the two with the turns of matched sweeps, where the robot turns. The gyro's drift is
/// its mean where the robot stands, else its median lead over the sweeps. Clearly better is: less
/// than half as far off, and nearer in two stretches of three.
/// @param up the vertical where tf tells it; else that of the gyro's six axes which fits best
[[nodiscard]] GyroVerdict judge_gyro(const std::vector<TurnedStretch>& stretches,
                                     const std::optional<Eigen::Vector3d>& up);

}  // namespace roomatlas::io
