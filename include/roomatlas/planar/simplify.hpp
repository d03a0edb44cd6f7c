// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <vector>

namespace roomatlas::planar {

/// The vertices of a ring that `simplified` keeps, ascending; all of them where less than a
/// triangle would stay.
[[nodiscard]] std::vector<std::size_t> corners_of(const Ring& ring, double tolerance);

/// The ring with fewer vertices, each dropped one within the tolerance of the ring that stays
/// (Douglas and Peucker 1973, between the two vertices that are farthest apart). A ring of which
/// less than a triangle would stay is returned as it is.
[[nodiscard]] Ring simplified(const Ring& ring, double tolerance);

/// All rings; holes that would become less than a triangle stay as they are. Rings that crossed
/// nothing may cross afterwards.
[[nodiscard]] Polygon simplified(const Polygon& polygon, double tolerance);

}  // namespace roomatlas::planar
