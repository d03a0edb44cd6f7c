// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

namespace roomatlas::planar {

/// The polygon, larger by the thickness on all sides, as raw rings: where they wind around a point
/// more often counter-clockwise than clockwise, the point is within `thickness_mm` of the polygon.
/// Corners are sharp up to a right angle and a little beyond, blunt from there on.
/// @param polygon_mm crosses itself nowhere; outer ring counter-clockwise, holes clockwise.
[[nodiscard]] Polygon wall_outline(const Polygon& polygon_mm, double thickness_mm);

}  // namespace roomatlas::planar
