// SPDX-License-Identifier: GPL-3.0-or-later
// The heading's chain (roomatlas/odometry/heading_chain.hpp) of a mission with sonars: what has to
// be added to odometry's heading so that each wall that was heard follows a direction of the
// building.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "roomatlas/odometry/heading_chain.hpp"
#include "roomatlas/odometry/noise.hpp"

namespace roomatlas {

struct SightingChainOptions {
  int states = 180;  ///< of the correction: half a degree each. More cost time, fewer blur it
  /// Of the heading between two nodes: 1.2 degrees/sqrt(m), 3 % of the turns, and 0.2 degrees
  /// however near they are. More than the batch's, whose walls hold a heading by their places, too.
  /// Smaller tears the heading off where odometry turned more than that; larger lets it wind the
  /// other way.
  OdometryNoise odometry{.position = {},
                         .heading = {.still = 0.0039, .per_sqrt_m = 0.0209, .per_rad = 0.03}};
  double jump_share = 1e-9;  ///< of the peak: odometry may do anything, rarely. 0 makes jumps
                             ///< impossible, and a chain with one without evidence
  double trust =
      0.15;  ///< share of the segments that follow the building; the rest lie anyhow.
             ///< Less than the true one (0.7), since the segments of one wall go together
  double segment_sigma_rad = 0.035;  ///< 2 degrees: of a wall's direction, however long
  double end_sigma_m = 0.0175;       ///< divided by the length: sigma of a wall's direction, 1
                                     ///< degree for 1 m
  double full_weight_m = 1.0;        ///< length from which on a segment counts in full; smaller
                                     ///< gives furniture the voice of walls
  double switch_share = 1e-3;  ///< a node: the walls around follow another direction now. Larger
                               ///< lets single segments have a direction of their own
};

/// A place of the chain.
struct HeadingNode {
  double path_m = 0.0;      ///< length of the path up to it, not decreasing
  double turned_rad = 0.0;  ///< sum of the sizes of the turns up to it
};

/// A wall that was heard at a node.
struct WallSighting {
  std::size_t node = 0;
  double direction_rad = 0.0;  ///< odometry's heading plus the wall's normal in the robot's frame
  double length_m = 0.0;       ///< above 0
};

/// @param nodes,sightings of the mission, the nodes along it
/// @param directions_rad of the building's walls, modulo 90 degrees; at least one
/// @returns a node each; evidence is relative to walls that lie anyhow, so that log evidence 0 says
///   nothing for the building's directions
[[nodiscard]] HeadingChain sighting_chain(std::span<const HeadingNode> nodes,
                                          std::span<const WallSighting> sightings,
                                          std::span<const double> directions_rad,
                                          const SightingChainOptions& options);

}  // namespace roomatlas
