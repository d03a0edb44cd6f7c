// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/mission/resample.hpp"

#include <cstdint>

namespace roomatlas::io {

/// What a driver's range means, by REP 117 and by sensor_msgs/LaserScan.
struct RangeLimits {
  double min_m = 0.0;  ///< below it drivers hide error codes
  double max_m = 0.0;  ///< of the sensor
  double trusted_m =
      0.0;  ///< at or beyond it a surface is not believed, but what is nearer is free
};
[[nodiscard]] Echo echo_of(float range_m, const RangeLimits& limits);

/// Beams by what came back, over a mission.
struct EchoCounts {
  std::int64_t beams = 0;
  std::int64_t nothing = 0;   ///< +Inf, or at the maximum
  std::int64_t invalid = 0;   ///< NaN, -Inf, zero or less
  std::int64_t too_near = 0;  ///< below the minimum
  std::int64_t too_far = 0;   ///< finite and beyond the maximum
  void add(float range_m, const RangeLimits& limits);
};

}  // namespace roomatlas::io
