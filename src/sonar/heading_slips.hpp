// SPDX-License-Identifier: GPL-3.0-or-later
// Where the heading of a mission may have wound another way.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sighting_chain.hpp"

namespace roomatlas {

/// Another way that the heading may have gone: by 90 degrees more, or less, from some place on.
struct HeadingSlip {
  double log_odds = 0.0;         ///< of the likeliest such way, against the likeliest without
  std::size_t first_node = 0;    ///< where it parts
  std::vector<double> more_rad;  ///< to be added from there on; the last value holds until the end
};

/// Whether both part, and have turned by all of it, at about the same places.
[[nodiscard]] bool are_one(const HeadingSlip& a, const HeadingSlip& b);

/// The likeliest ways to wind by a quarter turn more, or less, than a heading does, one for each
/// place that the walls leave open: between two of them odds fall. However unlikely they are,
/// their order tells where to look.
/// @param correction_rad the heading's, by node, unwrapped
/// @return those of at least the given log odds, the likeliest first
[[nodiscard]] std::vector<HeadingSlip> find_slips(std::span<const HeadingNode> nodes,
                                                  std::span<const WallSighting> sightings,
                                                  std::span<const double> directions_rad,
                                                  const SightingChainOptions& options,
                                                  const std::vector<double>& correction_rad,
                                                  double least_log_odds);

}  // namespace roomatlas
