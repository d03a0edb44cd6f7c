// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <vector>

namespace roomatlas::planar {

/// Whether no two edges of the polygon meet, but for neighbours in their common vertex.
[[nodiscard]] bool is_simple(const Polygon& polygon_mm);

/// What the polygon covers under the non-zero rule, as polygons that are simple but for vertices in
/// which two rings may meet: outer rings counter-clockwise, holes clockwise. Empty for a polygon
/// without area.
/// @param fine see `EdgeSet`: crossings lie on that grid.
[[nodiscard]] std::vector<Polygon> healed(const Polygon& polygon_mm, double fine);

}  // namespace roomatlas::planar
