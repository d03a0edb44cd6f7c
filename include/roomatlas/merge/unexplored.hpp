// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

struct UnexploredOptions {
  double reach_m = 0.3;          ///< a wall this near to the edge of free space is that edge's wall
  double thickest_wall_m = 0.6;  ///< free space this near on the other side: a wall between rooms
  double shortest_m = 0.6;       ///< shorter stretches are not worth a mark
};

/// Where the plan's free space ends although nobody saw a wall there: the limit of what was seen.
/// Doors are no such places, nor edges with free space close behind them.
/// @param walls_seen as the visits mapped them, in building metres
/// @returns stretches with free space to their left; empty for an empty plan
[[nodiscard]] std::vector<Polyline> unexplored_boundary(const FloorPlan& plan,
                                                        const std::vector<Polyline>& walls_seen,
                                                        const UnexploredOptions& options = {});

}  // namespace roomatlas
