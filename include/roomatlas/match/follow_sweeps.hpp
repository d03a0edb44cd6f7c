// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "roomatlas/match/scan_odometry.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// A sweep's time, and the robot's pose then by odometry and by the sweeps themselves.
struct FollowedSweep {
  double timestamp_s = 0.0;
  Pose2 odom_from_robot;
  Pose2 matched_from_robot;
  bool goes_on = false;  ///< the matched pose is in the frame of the sweep's before
};

struct FollowSweepsOptions {
  ScanOdometryOptions matching;
  double apart_s = 0.04;   ///< sweeps that follow sooner are passed over; fewer cost less
  int most_sweeps = 4000;  ///< then it ends; more cost 2 ms each
  int most_tries = 20;     ///< it begins anew where sweeps do not fit, so often
};

/// Follows a mission's lasers without its odometry, from where `mission` is: two answers to the
/// same question that know nothing of each other. Ends with the mission, at the options' bounds,
/// or where `take` returns false.
void follow_sweeps(MissionSource& mission, const FollowSweepsOptions& options,
                   const std::function<bool(const FollowedSweep&)>& take);

}  // namespace roomatlas
