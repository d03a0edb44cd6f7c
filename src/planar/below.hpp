// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "segment_grid.hpp"

namespace roomatlas::planar {

/// Finds what lies under a point. Keeps references to its arguments: they must outlive it.
class EdgeBelow {
 public:
  /// @param origin of each half-edge; 2e and 2e + 1 are twins. Edges meet in end points only.
  EdgeBelow(const std::vector<Point2>& points_mm, const std::vector<int>& origin);

  /// The half-edge, with its left side up, that is met first from the point straight down; -1:
  /// none. An edge counts from its left end to before its right end, so that of several that meet
  /// below the point the right one is found.
  [[nodiscard]] int half_edge_below(const Point2& point_mm) const;

 private:
  /// The half-edge of the edge that runs to the right; -1 for a vertical edge.
  [[nodiscard]] int rightwards(int edge) const;
  [[nodiscard]] const Point2& start(int half_edge) const {
    return points_[static_cast<std::size_t>(origin_[static_cast<std::size_t>(half_edge)])];
  }
  [[nodiscard]] const Point2& end(int half_edge) const { return start(half_edge ^ 1); }
  [[nodiscard]] bool is_above(int a, int b) const;

  const std::vector<Point2>& points_;
  const std::vector<int>& origin_;
  SegmentGrid grid_;
};

}  // namespace roomatlas::planar
