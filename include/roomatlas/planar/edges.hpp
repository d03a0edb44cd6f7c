// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <unordered_map>
#include <vector>

/// The planar map behind `merge`. Private: all coordinates are millimetres about a local origin.
namespace roomatlas::planar {

/// An edge of a ring, in the ring's direction, between two points.
struct RingEdge {
  int from = 0;
  int to = 0;
  int ring = 0;
};

/// Edges between numbered points. Points lie on a fine grid: whole multiples of 1 / `fine` mm, less
/// than 2^52 of them from each other, so that doubles hold them and their differences exactly.
struct EdgeSet {
  double fine = 0x1p16;           ///< units in a millimetre, a power of two
  std::vector<Point2> points_mm;  ///< distinct
  std::vector<RingEdge> edges;    ///< never from a point to itself

  [[nodiscard]] const Point2& point(int index) const {
    return points_mm[static_cast<std::size_t>(index)];
  }
};

/// The nearest point of the grid on which all of an `EdgeSet` lies.
[[nodiscard]] Point2 on_fine_grid(const Point2& point_mm, double fine);

/// Numbers points: equal ones have the same number.
class PointNumbers {
 public:
  /// @param points_mm gets the new ones; outlives this.
  explicit PointNumbers(std::vector<Point2>& points_mm, std::size_t expected);

  [[nodiscard]] int number_of(const Point2& point_mm);

 private:
  void grow();
  [[nodiscard]] std::size_t slot_of(const Point2& point_mm) const;

  std::vector<Point2>& points_;
  std::vector<int> slots_;  ///< a number, or -1; a power of two of them
};

/// The same edges cut wherever they meet: afterwards two edges have at most end points in common,
/// or both. A crossing is rounded to the fine grid, which may bend an edge by a fraction of a
/// micrometre; where the bent edge meets others it is cut again, until none do.
[[nodiscard]] EdgeSet cut_where_they_meet(EdgeSet set);

/// The same by CGAL's snap rounding, which is certain to end, and hundreds of times slower.
[[nodiscard]] EdgeSet cut_by_snap_rounding(const EdgeSet& set);

}  // namespace roomatlas::planar
