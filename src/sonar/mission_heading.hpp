// SPDX-License-Identifier: GPL-3.0-or-later
// The robot's heading over a mission with sonars, as the chain of its wall sightings says.
#pragma once

#include <span>
#include <vector>

#include "sighting_chain.hpp"

namespace roomatlas {

struct MissionHeading {
  double log_evidence = 0.0;           ///< against walls that lie anyhow
  std::vector<double> correction_rad;  ///< by node, to be added to odometry's heading; continuous:
                                       ///< no step exceeds 45 degrees
  std::vector<double> sigma_rad;       ///< by node, standard deviation
};

/// The log evidence of the chain alone; parameters as those of `sighting_chain`.
[[nodiscard]] double heading_evidence(std::span<const HeadingNode> nodes,
                                      std::span<const WallSighting> sightings,
                                      std::span<const double> directions_rad,
                                      const SightingChainOptions& options);

/// The mean of the chain's posterior about its mode, whatever the direction of the building that
/// the walls follow, unwrapped along the mission.
[[nodiscard]] MissionHeading mission_heading(std::span<const HeadingNode> nodes,
                                             std::span<const WallSighting> sightings,
                                             std::span<const double> directions_rad,
                                             const SightingChainOptions& options);

}  // namespace roomatlas
