// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/mission/mission.hpp"

#include <cstdint>
#include <vector>

namespace roomatlas::io {

/// What came back of one beam.
enum class Echo {
  surface,  ///< at the range that is reported
  nothing,  ///< nothing is within the sensor's range
  unknown,  ///< no reading: an error code, dust on the lens, a broken beam
};

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

/// One beam of a sweep, as a ray in the frame of the robot where the reading is placed.
struct SweepRay {
  Point2 origin = Point2::Zero();
  Point2 end = Point2::Zero();  ///< of `nothing` and `unknown`: anywhere on the ray
  Echo echo = Echo::unknown;
};

/// A sweep as another sensor would have measured it: where a ray of `onto` meets the surface
/// between two neighbouring ends that lie on one surface, else as its nearest neighbour in bearing
/// has it.
/// @param rays counter-clockwise
/// @param onto beams that start at one point and are evenly spaced, counter-clockwise
/// @returns a range a beam of `onto`: `max_range_m` for nothing, NaN where no ray was near
[[nodiscard]] std::vector<float> resampled(const std::vector<SweepRay>& rays,
                                           const RangeSensor& onto);

}  // namespace roomatlas::io
