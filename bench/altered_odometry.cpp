// SPDX-License-Identifier: GPL-3.0-or-later
#include "altered_odometry.hpp"

#include <cmath>
#include <random>

#include "roomatlas/evaluate/pose_lookup.hpp"

namespace roomatlas::bench {
namespace {

/// Nearly: the sum of twelve uniform numbers.
double normal(std::mt19937_64& engine) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += static_cast<double>(engine() >> 11) * 0x1.0p-53;
  return sum;
}

}  // namespace

void alter_odometry(std::vector<RangeReading>& readings, const OdometryChange& how, int seed) {
  std::mt19937_64 engine(static_cast<std::uint64_t>(seed) + 77);
  Trajectory reported;
  for (const RangeReading& reading : readings) {
    reported.push_back({reading.timestamp_s, reading.odom_from_robot});
  }
  if (how.lag_s != 0.0) {
    for (StampedPose& at : reported) at.timestamp_s += how.lag_s;
    const PoseLookup lookup(reported, {TimeMatch::interpolate, {}}, nullptr);
    Trajectory late;
    for (const RangeReading& reading : readings) {
      const auto found = lookup.at(reading.timestamp_s);
      late.push_back({reading.timestamp_s, found ? found->pose : reading.odom_from_robot});
    }
    reported = late;
  }
  Pose2 pose = reported.front().pose;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (i > 0) {
      Pose2 step = inverse(reported[i - 1].pose) * reported[i].pose;
      const double way_m = step.position().norm();
      const double forwards_m = step.x_m < 0.0 ? -way_m : way_m;
      step.x_m *= how.length_scale;
      step.y_m *= how.length_scale;
      step.theta_rad = how.turn_gain * step.theta_rad + radians(how.bias_deg_per_m) * forwards_m +
                       radians(how.noise_deg_per_sqrt_m) * std::sqrt(way_m) * normal(engine);
      pose = pose * step;
    }
    readings[i].odom_from_robot = pose;
  }
}

}  // namespace roomatlas::bench
