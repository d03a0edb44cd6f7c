// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <vector>

namespace roomatlas::planar {

/// Shapes that together cover everything within `thickness_mm` outside of the polygon's edges:
/// a rectangle along each edge and a corner piece at each convex vertex, sharp up to a right
/// angle and a little beyond, blunt from there on.
/// @param polygon_mm outer ring counter-clockwise, holes clockwise, as `PlanarMap::trace` gives.
[[nodiscard]] std::vector<Polygon> wall_bands(const Polygon& polygon_mm, double thickness_mm);

}  // namespace roomatlas::planar
