// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas::io {

/// A door that a file shows: where, and how wide.
struct ShownDoor {
  Point2 at = Point2::Zero();  ///< metres
  double width_m = 0.0;
};

/// The door of a plan between the two rooms whose edges are nearest to it, at most 0.6 m away; one
/// room alone where there is no second. Nothing where no room is that near.
[[nodiscard]] std::optional<PlanDoor> door_of_rooms(const std::vector<PlanRoom>& rooms,
                                                    const ShownDoor& shown, DoorId id);

/// Thin walls along all edges of the rooms, open where the doors are, and along both sides of
/// doorways through thicker walls. Several may lie on each other.
[[nodiscard]] std::vector<Polygon> walls_of_rooms(const FloorPlan& plan);

}  // namespace roomatlas::io
