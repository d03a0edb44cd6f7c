// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <vector>

namespace roomatlas {

/// How far points are from a polygon's boundary, for many points of one polygon.
class Clearance {
 public:
  explicit Clearance(const Polygon& polygon);

  /// Distance to the nearest edge in metres, negative outside (even-odd rule); minus infinity for a
  /// polygon without edges.
  [[nodiscard]] double at(const Point2& point) const;

 private:
  struct Edge {
    Point2 from;
    Point2 along;
    double inverse_squared_length;  ///< 0 for an edge without length
  };
  std::vector<Edge> edges_;
};

}  // namespace roomatlas
