// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/plan/floor_plan.hpp"

/// What formats need that know rooms up to the door line, or buildings as wholes. Private.
namespace roomatlas::io {

/// Which part of a door's hole lies on which side of its door line.
struct DoorSides {
  Ring left;   ///< of the way from jamb a to jamb b; begins with both jambs; empty where none is
  Ring right;  ///< the same
  std::optional<RoomId> left_room;  ///< the room on that side, where one is
  std::optional<RoomId> right_room;
};

/// Corners are rounded to the millimetre, as `to_millimetre` does.
[[nodiscard]] DoorSides sides_of(const PlanDoor& door, const FloorPlan& plan);

/// A room with its halves of the holes of doors and passages: two rooms touch along the door line.
/// Largest part first.
[[nodiscard]] std::vector<Polygon> up_to_doors(const PlanRoom& room, const FloorPlan& plan,
                                               const std::vector<DoorSides>& doors);

/// A wall's body where doors, passages and windows are gaps in it; in most plans they are already.
[[nodiscard]] std::vector<Polygon> without_holes_of_doors(const Polygon& wall,
                                                          const FloorPlan& plan);

/// What the building covers with all that is inside, without holes, largest first.
[[nodiscard]] std::vector<Polygon> covered_by(const FloorPlan& plan);

}  // namespace roomatlas::io
