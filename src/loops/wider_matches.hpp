// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms that were found away from where they lie: which of them would move alike.
#pragma once

#include <cstddef>
#include <vector>

#include "roomatlas/match/match_maps.hpp"

namespace roomatlas {

/// A match of two rooms far from where they lie.
struct WiderMatch {
  std::size_t pair = 0;  ///< the caller's name for it
  MapMatch match;
  int gain = 0;             ///< of score, against where they lie
  Pose2 building_from_was;  ///< where the second room lies ...
  Pose2 building_from_is;   ///< ... and where the match would put it
};

/// Takes out of `found` those that would move their rooms like one of them does, the one that
/// gains most together with its likes: where the robot was lost once, everything behind moves as
/// a whole, while false matches move each their own way.
/// @param found not empty
[[nodiscard]] std::vector<WiderMatch> take_most_alike(std::vector<WiderMatch>& found);

[[nodiscard]] int gain_of(const std::vector<WiderMatch>& matches);

}  // namespace roomatlas
