// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/walls.hpp"
#include "roomatlas/plan/door.hpp"

namespace roomatlas {

struct StraightOpeningOptions {
  double least_turn_deg = 3.0;   ///< of an opening from a wall: less is straight ...
  double most_turn_deg = 40.0;   ///< ... and more is another wall's
  double beside_m = 0.2;         ///< from its jamb to the wall that it should go on
  double most_aside_m = 1.6;     ///< how far the other jamb may move
  double least_support_m = 0.8;  ///< of that wall, seen on its line
};

/// An opening from where a wall ends to something that stands before the next one, a cupboard or a
/// desk, lies aslant. It is turned about the wall's end into the line on which the wall goes on.
/// Openings along any wall stay as they are, and so do those at whose ends no wall is.
[[nodiscard]] Door straightened(const Door& opening, const Walls& walls,
                                const StraightOpeningOptions& options);

}  // namespace roomatlas
