// SPDX-License-Identifier: GPL-3.0-or-later
// The robot's heading over a mission as a hidden Markov model: what has to be added to odometry's
// heading, modulo 90 degrees, so that walls follow the directions of the building.
#pragma once

#include <span>
#include <vector>

namespace roomatlas {

struct HeadingChainOptions {
  int states = 180;                      ///< of the correction; more cost time, fewer blur it
  double drift_rad_per_sqrt_m = 0.0209;  ///< 1.2 degrees: random walk of odometry's heading
  double drift_per_turn = 0.03;          ///< of each turn
  double base_rad = 0.0039;              ///< between any two nodes
  double jump_share = 1e-9;              ///< of the peak: odometry may do anything, rarely
  double trust = 0.15;  ///< share of the segments that follow the building; the rest lie anyhow.
                        ///< Less than the true one, since the segments of one wall go together
  double segment_sigma_rad = 0.035;  ///< of a wall's direction, however long
  double end_sigma_m = 0.0175;       ///< divided by the length: sigma of a wall's direction
  double full_weight_m = 1.0;        ///< length from which on a segment counts in full
  double switch_share = 1e-3;        ///< a node: the walls around follow another direction now
};

/// A place of the chain.
struct HeadingNode {
  double path_m = 0.0;
  double turned_rad = 0.0;
};

/// A wall that was seen at a node.
struct WallSighting {
  std::size_t node = 0;
  double direction_rad = 0.0;  ///< odometry's heading plus the wall's normal in the robot's frame
  double length_m = 0.0;
};

struct HeadingChain {
  double log_evidence = 0.0;           ///< against walls that lie anyhow
  std::vector<double> correction_rad;  ///< by node, continuous: no step exceeds 45 degrees
  std::vector<double> sigma_rad;       ///< by node
};

/// Forward pass alone: the log evidence.
/// @param directions_rad of the building's walls modulo 90 degrees; at least one
[[nodiscard]] double heading_evidence(std::span<const HeadingNode> nodes,
                                      std::span<const WallSighting> sightings,
                                      std::span<const double> directions_rad,
                                      const HeadingChainOptions& options);

/// The exact posterior by forward and backward pass, its mean about its mode, unwrapped.
[[nodiscard]] HeadingChain smooth_heading(std::span<const HeadingNode> nodes,
                                          std::span<const WallSighting> sightings,
                                          std::span<const double> directions_rad,
                                          const HeadingChainOptions& options);

}  // namespace roomatlas
