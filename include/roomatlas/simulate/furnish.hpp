// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/floor_plan.hpp"
#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas {

struct FurnishOptions {
  RobotFootprint footprint;  ///< where this robot could turn, it still can, or something stands
  double amount = 1.0;       ///< times what such rooms hold; 0: leaves alone
  double open_doors_share = 0.6;    ///< of the doors have a leaf that stands open, [0, 1]
  double door_clearance_m = 1.1;    ///< around doors nothing stands but their leaf
  double way_width_m = 0.9;         ///< of the ways between pieces; smaller packs rooms denser
  double route_clearance_m = 0.35;  ///< from the route's middle line
  Drive route;  ///< of the robot, or the one place where it starts; may be empty
};

/// The world with what a building holds: desks with chairs, tables, rows of cupboards along walls,
/// boxes, and door leaves that stand open by 60 to 120 degrees; by kind and size of the rooms. What
/// is in the world already stays. Every piece stands in one room, overlaps nothing, and keeps clear
/// of doors (but for leaves) and of the route. Wherever the robot could turn and nothing stands
/// now, it gets to as before; and ways of `way_width_m` join what remains free in each room (0.25
/// m2 and more) with each other and with the doors. A piece for which there is no such place is
/// left out. The same world, seed and options give the same plan.
/// @param world rooms are needed; doors should say which rooms they join
/// @throws InputError for a world without rooms
/// @throws UsageError for an option out of its range
[[nodiscard]] FloorPlan furnished(FloorPlan world, std::uint64_t seed,
                                  const FurnishOptions& options);

}  // namespace roomatlas
