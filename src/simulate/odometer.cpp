// SPDX-License-Identifier: GPL-3.0-or-later
#include "odometer.hpp"

#include <cmath>

namespace roomatlas {

Odometer::Odometer(const OdometryErrors& errors, std::uint64_t seed)
    : errors_(errors), heading_noise_(seed, "odometry heading") {}

Odometer::Increment Odometer::add(double length_m, double turn_rad) {
  Increment reported{length_m * (1.0 + errors_.length_share), turn_rad};
  if (length_m > 0.0) {
    reported.turn_rad += radians(errors_.heading_bias_deg_per_m * length_m);
    reported.turn_rad += radians(errors_.heading_noise_deg_per_sqrt_m * std::sqrt(length_m)) *
                         heading_noise_.normal();
  }
  // The heading error builds up along the way: half of it bends the first part of the step.
  const double half_turn_rad = reported.turn_rad / 2.0;
  odom_from_robot_ = odom_from_robot_ * Pose2{0.0, 0.0, half_turn_rad} *
                     Pose2{reported.length_m, 0.0, half_turn_rad};
  return reported;
}

}  // namespace roomatlas
