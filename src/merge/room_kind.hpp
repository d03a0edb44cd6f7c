// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/merge/floor_plan.hpp"

namespace roomatlas {

/// Corridor: long (over three times its mean width) and narrow (under 3.5 m). Hall: over 80 m2
/// and no corridor. The width of a shape that encloses others (a ring of corridors) is that of
/// the largest circle inside it.
/// @param largest_part not empty; @param inner its `interior_point`.
[[nodiscard]] RoomKind kind_of(const Polygon& largest_part, const Point2& inner, double area_m2);

}  // namespace roomatlas
