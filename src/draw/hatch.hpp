// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <vector>

namespace roomatlas::drawing {

/// Parallel lines across a polygon on paper, clipped to it (even-odd). Lines of neighbouring
/// polygons lie on one grid.
/// @param angle_rad of the lines, counter-clockwise from the right on the sheet
/// @param pitch_mm from line to line
[[nodiscard]] std::vector<Segment2> hatched(const Polygon& polygon_mm, double angle_rad,
                                            double pitch_mm);

}  // namespace roomatlas::drawing
