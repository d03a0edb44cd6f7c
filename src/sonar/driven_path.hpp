// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "roomatlas/sonar/sonar_trajectory.hpp"

namespace roomatlas {

/// Odometry without its habits.
struct DrivenPath {
  std::vector<Pose2> odom_from_robot;  ///< one a reading, from odometry's first pose
  std::vector<double> path_m;          ///< length of the path up to each
  std::vector<double> turned_rad;      ///< sum of the sizes of the turns up to each
  std::vector<double> undecided_m;     ///< path up to each that could have gone either way
};

[[nodiscard]] DrivenPath driven_path(std::span<const RangeReading> readings,
                                     const DriveDirections& directions,
                                     const OdometryHabits& habits);

/// Habits with which odometry comes nearest to poses that were found otherwise; without lag.
/// @param odom_from_robot,map_from_robot one a reading
/// @param are_lengths_seen whether walls told the poses' lengths
[[nodiscard]] OdometryHabits habits_between(std::span<const Pose2> odom_from_robot,
                                            std::span<const Pose2> map_from_robot,
                                            bool are_lengths_seen);

/// Turns the headings of a path by an angle for each reading; the steps in between are driven at
/// the mean of the turns at their ends.
[[nodiscard]] std::vector<Pose2> with_headings(const DrivenPath& path,
                                               std::span<const double> turn_rad);

/// Readings after which the robot has driven or turned by so much since the last of them; the
/// first reading is one.
[[nodiscard]] std::vector<std::size_t> nodes_along(const DrivenPath& path, double step_m,
                                                   double turn_rad);

/// How far a reading stands between two nodes, [0, 1], by way and turn.
[[nodiscard]] double share_between(const DrivenPath& path, std::size_t from, std::size_t to,
                                   std::size_t reading);

}  // namespace roomatlas
