// SPDX-License-Identifier: GPL-3.0-or-later
#include "below.hpp"

#include "predicates.hpp"

#include <algorithm>

namespace roomatlas::planar {

EdgeBelow::EdgeBelow(const std::vector<Point2>& points_mm, const std::vector<int>& origin)
    : points_(points_mm), origin_(origin), grid_(points_mm, origin) {}

int EdgeBelow::rightwards(int edge) const {
  const int half_edge = 2 * edge;
  const double from = start(half_edge).x();
  const double to = end(half_edge).x();
  if (from == to) return -1;
  return from < to ? half_edge : half_edge + 1;
}

/// Of two edges that do not cross and have an x in common, both running to the right.
bool EdgeBelow::is_above(int a, int b) const {
  if (start(a).x() >= start(b).x()) {
    const int side = orientation(start(b), end(b), start(a));
    if (side != 0) return side > 0;
  } else {
    const int side = orientation(start(a), end(a), start(b));
    if (side != 0) return side < 0;
  }
  return end(a).x() <= end(b).x() ? orientation(start(b), end(b), end(a)) > 0
                                  : orientation(start(a), end(a), end(b)) < 0;
}

int EdgeBelow::half_edge_below(const Point2& point_mm) const {
  const int column = grid_.column_of(point_mm.x());
  int best = -1;
  int last_row = 0;  // an edge that passes through a cell may be met in a lower one
  for (int row = grid_.row_of(point_mm.y()); row >= last_row; --row) {
    for (const int edge : grid_.in_cell(column, row)) {
      const int candidate = rightwards(edge);
      if (candidate < 0 || candidate == best) continue;
      const bool is_in_reach = start(candidate).x() <= point_mm.x() &&
                               point_mm.x() < end(candidate).x() &&
                               orientation(start(candidate), end(candidate), point_mm) > 0;
      if (!is_in_reach || (best >= 0 && !is_above(candidate, best))) continue;
      best = candidate;
      const Point2 along = end(best) - start(best);
      const double rise = along.y() / along.x();
      last_row =
          std::max(0, grid_.row_of(start(best).y() + rise * (point_mm.x() - start(best).x())) - 1);
    }
  }
  return best;
}

}  // namespace roomatlas::planar
