// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

namespace roomatlas::planar {

/// The ring with fewer vertices, each dropped one within the tolerance of the ring that stays
/// (Douglas and Peucker 1973, between the two vertices that are farthest apart). A ring of which
/// less than a triangle would stay is returned as it is.
[[nodiscard]] Ring simplified(const Ring& ring, double tolerance);

/// All rings; holes that would become less than a triangle stay as they are. Rings that crossed
/// nothing may cross afterwards.
[[nodiscard]] Polygon simplified(const Polygon& polygon, double tolerance);

}  // namespace roomatlas::planar
