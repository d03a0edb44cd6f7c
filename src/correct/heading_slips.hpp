// SPDX-License-Identifier: GPL-3.0-or-later
// Where the heading of a mission may have wound another way.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "heading_chain.hpp"

namespace roomatlas {

/// Another way that the heading may have gone: by 90 degrees more, or less, from some place on.
struct HeadingSlip {
  double share = 0.0;            ///< of the posterior, [0, 1]
  std::size_t first_node = 0;    ///< where it parts
  std::vector<double> more_rad;  ///< to be added from there on; the last value holds until the end
};

/// Where paths drawn from the posterior (forward filtering, backward sampling) wind another way
/// than the mean, the likeliest first. The same paths each time.
[[nodiscard]] std::vector<HeadingSlip> find_slips(std::span<const HeadingNode> nodes,
                                                  std::span<const WallSighting> sightings,
                                                  std::span<const double> directions_rad,
                                                  const HeadingChainOptions& options,
                                                  const std::vector<double>& mean_rad);

}  // namespace roomatlas
