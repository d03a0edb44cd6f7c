// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// What came back of one beam.
enum class Echo {
  surface,  ///< at the range that is reported
  nothing,  ///< nothing is within the sensor's range
  unknown,  ///< no reading: an error code, dust on the lens, a broken beam
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

}  // namespace roomatlas
