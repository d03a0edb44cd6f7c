// SPDX-License-Identifier: GPL-3.0-or-later
// Which walls single returns came from, as the poses stand.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomatlas/core/pose2.hpp"
#include "wall_pairs.hpp"

namespace roomatlas {

/// One return of a sonar in the frame of the node at which it was heard.
struct SeenReturn {
  std::size_t node = 0;
  Pose2 node_from_sonar;
  double range_m = 0.0;
  double half_cone_rad = 0.0;
  double path_m = 0.0;  ///< where on its way the robot heard it
  double share = 1.0;   ///< one over the number of the robot's sonars
};

/// A return, and a stretch of wall of another visit that it may have come from.
struct ReturnMatch {
  std::uint32_t heard = 0;  ///< of the returns
  std::uint32_t wall = 0;   ///< of the walls
  double share = 1.0;       ///< one over the number of the return's matches
};

/// Matches of returns with walls that other visits saw where the return would have come from, at
/// most three of each return, by return. Walls of the same place on the way would say again what
/// the return's own stretch says.
[[nodiscard]] std::vector<ReturnMatch> find_return_matches(std::span<const SeenReturn> returns,
                                                           std::span<const SeenWall> walls,
                                                           std::span<const Pose2> map_from_node);

}  // namespace roomatlas
