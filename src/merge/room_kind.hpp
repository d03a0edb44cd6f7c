// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// Corridor: long (over three times its mean width, measured along the oriented bounding box
/// unless the shape runs around others) and narrow (under 3.5 m nearly everywhere).
/// Hall: over 80 m2 and no corridor.
/// @param largest_part of the room, not empty.
[[nodiscard]] RoomKind kind_of(const Polygon& largest_part, double area_m2);

}  // namespace roomatlas
