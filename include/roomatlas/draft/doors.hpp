// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/evidence.hpp"
#include "roomatlas/draft/occupancy.hpp"
#include "roomatlas/draft/walls.hpp"
#include "roomatlas/plan/door.hpp"

namespace roomatlas {

struct DoorOptions {
  double reach_m = 0.6;             ///< from an opening to the wall that it is in
  double max_turn_deg = 20.0;       ///< of an opening from its wall
  double narrowest_m = 0.3;         ///< narrower openings are none
  double narrowest_unused_m = 0.5;  ///< of openings that sonars heard and nobody drove through
  double widest_door_m = 1.4;       ///< wider openings are passages
  double glass_share = 0.03;  ///< of the beams across an opening that nobody went through: from
                              ///< here on something is in it that most of them pass
};

/// Puts openings between rooms into their walls: the jambs lie on the wall's middle line where its
/// faces end, by the surfaces that lasers saw or by what sonars' echoes make most likely. Openings
/// that lie in no known wall stay where they are. Kinds follow; rooms and crossings stay.
[[nodiscard]] std::vector<Door> placed_doors(const std::vector<Door>& openings, const Walls& walls,
                                             const BuildingEvidence& evidence,
                                             const DoorOptions& options);

}  // namespace roomatlas
