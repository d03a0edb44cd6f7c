// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/core/geometry.hpp"

namespace roomatlas::changes {

/// The rectangle of least area around points, of whatever direction (to 3 degrees).
struct Extent {
  Point2 middle = Point2::Zero();
  Point2 along = Point2(1.0, 0.0);  ///< unit, of its longer side
  double length_m = 0.0;            ///< of its longer side
  double width_m = 0.0;

  [[nodiscard]] Point2 across() const { return {-along.y(), along.x()}; }
};

/// @param margin_m added all around: half a cell, where the points are middles of cells
[[nodiscard]] Extent extent_of(const std::vector<Point2>& points, double margin_m = 0.0);

/// The rectangle as a ring.
[[nodiscard]] Ring ring_of(const Extent& extent);

/// How far a point is from a polygon's edge; 0 inside.
[[nodiscard]] double distance_m(const Polygon& polygon, const Point2& point);

}  // namespace roomatlas::changes
