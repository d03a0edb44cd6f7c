// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// True where somebody named the room: its name is not its number.
[[nodiscard]] bool is_named(const PlanRoom& room);

/// What became of the rooms.
struct CarriedOver {
  std::map<RoomId, RoomId> number;  ///< of each room of the plan: now, by what it was
  std::vector<PlanRoom> absent;     ///< named rooms that were not found again, as they were
  Issues lost;                      ///< a warning for each of them
};

/// Gives rooms other numbers; doors and edges follow, and rooms are then in the order of their
/// numbers. Rooms without a number in `number` keep theirs.
void renumber(FloorPlan& plan, const std::map<RoomId, RoomId>& number);

/// Gives the rooms of a plan the numbers, and the names that somebody gave, of those rooms of the
/// former plan whose polygons they overlap most; largest overlap first, each room once, and only
/// where a quarter of the smaller room is shared. Other rooms keep their numbers where these are
/// free, else they get numbers above all that were used. Rooms are then in the order of their
/// numbers, and doors, edges and `room_of_asr` follow. A room of the plan that is named keeps that
/// name, and no other gets it. Both plans must be in one frame. What is lost is in the plan's
/// issues too.
CarriedOver carry_over(const std::vector<PlanRoom>& former, FloorPlan& plan,
                       std::map<AsrId, RoomId>& room_of_asr);

}  // namespace roomatlas
