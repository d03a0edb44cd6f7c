// SPDX-License-Identifier: GPL-3.0-or-later
#include "odometer.hpp"

#include <cmath>
#include <stdexcept>

namespace roomatlas {

OdometryErrors odometry_errors(OdometryPreset preset) {
  switch (preset) {
    case OdometryPreset::mild:
      return {0.005, 0.1, 1.0, 0.0};
    case OdometryPreset::typical:
      return {0.01, 0.3, 2.0, 0.0};
    case OdometryPreset::hard:
      return {-0.04, 3.3, 2.0, -0.04};
  }
  throw std::invalid_argument("unknown odometry preset");
}

Odometer::Odometer(const OdometryErrors& errors, std::uint64_t seed)
    : errors_(errors), heading_noise_(seed, "odometry heading") {}

Odometer::Increment Odometer::add(double length_m, double turn_rad) {
  Increment reported{length_m * (1.0 + errors_.length_share),
                     turn_rad * (1.0 + errors_.turn_share)};
  const double driven_m = std::abs(length_m);
  if (driven_m > 0.0) {
    reported.turn_rad += radians(errors_.heading_bias_deg_per_m * driven_m);
    reported.turn_rad += radians(errors_.heading_noise_deg_per_sqrt_m * std::sqrt(driven_m)) *
                         heading_noise_.normal();
  }
  // The heading error builds up along the way: half of it bends the first part of the step.
  const double half_turn_rad = reported.turn_rad / 2.0;
  odom_from_robot_ = odom_from_robot_ * Pose2{0.0, 0.0, half_turn_rad} *
                     Pose2{reported.length_m, 0.0, half_turn_rad};
  return reported;
}

}  // namespace roomatlas
