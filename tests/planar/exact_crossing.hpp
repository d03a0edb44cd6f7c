// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <cmath>
#include <cstdint>

namespace roomatlas::test {

/// A point of a fine grid, in whole numbers.
struct FinePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  bool operator==(const FinePoint&) const = default;
};

/// @param units of the grid in a millimetre.
inline FinePoint fine(const Point2& point_mm, double units) {
  return {std::llround(point_mm.x() * units), std::llround(point_mm.y() * units)};
}

__extension__ using Wide = __int128;

/// Twice the area of the triangle, counter-clockwise positive, without rounding.
inline Wide doubled_area(const FinePoint& a, const FinePoint& b, const FinePoint& c) {
  return static_cast<Wide>(b.x - a.x) * (c.y - a.y) - static_cast<Wide>(b.y - a.y) * (c.x - a.x);
}

inline int side(const FinePoint& a, const FinePoint& b, const FinePoint& c) {
  const Wide doubled = doubled_area(a, b, c);
  return doubled > 0 ? 1 : doubled < 0 ? -1 : 0;
}

/// Whether the inner parts of two edges cross in one point.
inline bool cross_inside(const FinePoint& a, const FinePoint& b, const FinePoint& c,
                         const FinePoint& d) {
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// Whether `p` lies on the edge, not in its ends.
inline bool is_inside_edge(const FinePoint& a, const FinePoint& b, const FinePoint& p) {
  if (p == a || p == b || side(a, b, p) != 0) return false;
  const Wide along =
      static_cast<Wide>(p.x - a.x) * (b.x - a.x) + static_cast<Wide>(p.y - a.y) * (b.y - a.y);
  const Wide whole =
      static_cast<Wide>(b.x - a.x) * (b.x - a.x) + static_cast<Wide>(b.y - a.y) * (b.y - a.y);
  return along > 0 && along < whole;
}

}  // namespace roomatlas::test
