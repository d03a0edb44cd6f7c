// SPDX-License-Identifier: GPL-3.0-or-later
// What the stress programs do to a log's odometry.
#pragma once

#include <vector>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas::bench {

struct OdometryChange {
  double bias_deg_per_m = 0.0;
  double turn_gain = 1.0;
  double length_scale = 1.0;
  double noise_deg_per_sqrt_m = 0.0;
  double lag_s = 0.0;
};

/// Writes what odometry with these habits would have reported into the readings.
void alter_odometry(std::vector<RangeReading>& readings, const OdometryChange& change, int seed);

}  // namespace roomatlas::bench
