// SPDX-License-Identifier: GPL-3.0-or-later
// The directions that walls follow on a map, whatever was thought of them before.
#pragma once

#include <span>
#include <vector>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/sonar/wall_segments.hpp"

namespace roomatlas {

struct MapDirectionsOptions {
  double blur_rad = 0.035;  ///< 2 degrees, as walls scatter; larger merges wings at small angles
  double least_apart_rad = 0.14;  ///< 8 degrees: nearer ones are one, seen with noise
  double least_share = 0.2;       ///< of the first one's length of wall; smaller believes furniture
  std::size_t most = 3;           ///< more would fit anything
};

/// The directions, modulo 90 degrees in [-pi/4, pi/4), that most metres of wall follow: peaks of
/// their blurred density, the highest first. Empty without walls.
/// @param map_from_robot one a reading
[[nodiscard]] std::vector<double> map_directions(std::span<const WallSegment> segments,
                                                 std::span<const Pose2> map_from_robot,
                                                 const MapDirectionsOptions& options);

}  // namespace roomatlas
