// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"

#include <algorithm>

namespace roomatlas {

// What a number in a log can mean. One that is beyond these is a slip: a map that believed it would
// not fit into memory.

/// A coordinate of the robot, from the origin. The plan holds 10,000 km; the walls that the robot
/// sees, and the drift that is taken out, need a little of it.
constexpr double kFarthest_m = 9.99e6;
/// A sensor, from the robot's centre.
constexpr double kFarthestMount_m = 10.0;
/// Between two poses that follow each other: what the fastest robot drives in that time ...
constexpr double kFastest_m_per_s = 20.0;
/// ... and what a log may leave out or correct without saying so.
constexpr double kSmallJump_m = 10.0;

/// True when no robot drives from one to the other in the time between. Without times, or where
/// they step back, only `kSmallJump_m` is granted.
[[nodiscard]] inline bool is_jump(const StampedPose& from, const StampedPose& to) {
  const double time_s = std::max(0.0, to.timestamp_s - from.timestamp_s);
  return (to.pose.position() - from.pose.position()).norm() >
         kSmallJump_m + kFastest_m_per_s * time_s;
}

}  // namespace roomatlas
