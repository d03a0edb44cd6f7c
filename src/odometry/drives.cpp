// SPDX-License-Identifier: GPL-3.0-or-later
#include "drives.hpp"

namespace roomatlas {

Pose2 driven(const Pose2& reported_step, DriveDirection direction) {
  if (direction != DriveDirection::reversed) return reported_step;
  return {-reported_step.x_m, -reported_step.y_m, reported_step.theta_rad};
}

Pose2 reported_step(const RangeReading& from, const RangeReading& to) {
  return inverse(from.odom_from_robot) * to.odom_from_robot;
}

bool is_stop(const Pose2& step, const DriveDirectionOptions& options) {
  return step.position().norm() < options.stop_step_m;
}

bool can_tell(double apart_m, const DriveDirectionOptions& options) {
  return apart_m >= options.min_apart_m && apart_m <= options.max_apart_m;
}

DriveDirection decided(double log_odds, const DriveDirectionOptions& options) {
  if (log_odds > options.flip_log_odds) return DriveDirection::reversed;
  return log_odds > options.undecided_log_odds ? DriveDirection::undecided
                                               : DriveDirection::as_reported;
}

}  // namespace roomatlas
