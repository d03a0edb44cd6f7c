// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/loops/closures.hpp"
#include "roomatlas/sonar/wall_segments.hpp"

namespace roomatlas {

struct SonarShapeOptions {
  WallSegmentOptions segments;
  double cell_m = 0.1;           ///< of the map
  double sample_m = 0.1;         ///< along a stretch of wall
  double free_range_m = 3.0;     ///< an echo from farther frees nothing: its cone is wide
  double short_of_echo_m = 0.3;  ///< where the freed ray ends
  double every_m = 0.1;          ///< of the robot, between readings whose rays free the floor
};

/// What a visit of sonars looks like to a matcher: stretches of wall from consecutive returns, and
/// the floor along the axes of the cones.
/// @param asr with readings and path, the path good over a few metres
[[nodiscard]] AsrShape sonar_shape_of(const Asr& asr, const SonarShapeOptions& options);

}  // namespace roomatlas
