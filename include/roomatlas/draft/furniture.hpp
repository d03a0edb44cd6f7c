// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/draft_plan.hpp"

namespace roomatlas {

struct FurnitureOptions {
  double off_wall_m = 0.09;     ///< obstacles nearer to the room's edge are the wall's
  double min_area_m2 = 0.03;    ///< smaller are noise
  double against_wall_m = 0.2;  ///< pieces this near to the room's edge stand against it
  double seen_share = 0.4;      ///< of a piece's edge where something was seen to stand
  double simplify_m = 0.06;
};

/// What stands in the rooms: obstacles off their walls, and what nobody saw behind them. Says no
/// more than whether a piece stands against a wall: its legs or its front are all that was seen.
[[nodiscard]] std::vector<PlanFurniture> find_furniture(const std::vector<DraftedRoom>& rooms,
                                                        const Occupancy& occupancy,
                                                        const FurnitureOptions& options);

}  // namespace roomatlas
