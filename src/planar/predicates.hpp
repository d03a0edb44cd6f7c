// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <cmath>

namespace roomatlas::planar {

/// The answer of `orientation` where rounded arithmetic cannot tell: CGAL's exact predicate.
[[nodiscard]] int exact_orientation(const Point2& a, const Point2& b, const Point2& c);

/// 1 when `c` lies left of the line from `a` to `b`, -1 right of it, 0 on it. Exact for points of
/// `EdgeSet`, whose differences doubles hold exactly: then each product is off by half a unit in
/// its last place, and their difference by as much again.
[[nodiscard]] inline int orientation(const Point2& a, const Point2& b, const Point2& c) {
  constexpr double kRounding = 0x1p-51;  // twice what these add up to
  const double left = (b.x() - a.x()) * (c.y() - a.y());
  const double right = (b.y() - a.y()) * (c.x() - a.x());
  const double difference = left - right;
  if (std::abs(difference) > kRounding * (std::abs(left) + std::abs(right))) {
    return difference > 0.0 ? 1 : -1;
  }
  return left == 0.0 && right == 0.0 ? 0 : exact_orientation(a, b, c);
}

}  // namespace roomatlas::planar
