// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/planar/edges.hpp"

#include <span>
#include <vector>

namespace roomatlas::planar {

/// Square cells, each with the edges that pass through it: what is near an edge, without asking
/// all.
class SegmentGrid {
 public:
  /// @param of indices of edges of the set.
  SegmentGrid(const EdgeSet& set, const std::vector<int>& of);
  /// @param ends_of_edges two point numbers an edge.
  SegmentGrid(const std::vector<Point2>& points_mm, const std::vector<int>& ends_of_edges);

  [[nodiscard]] int cell_count() const { return columns_ * rows_; }
  /// Places in `of`, or indices of edges. Some may pass the cell by within a rounding error.
  [[nodiscard]] std::span<const int> in_cell(int cell) const {
    const auto begin = static_cast<std::size_t>(first_[static_cast<std::size_t>(cell)]);
    const auto end = static_cast<std::size_t>(first_[static_cast<std::size_t>(cell) + 1]);
    return {entries_.data() + begin, end - begin};
  }
  [[nodiscard]] std::span<const int> in_cell(int column, int row) const {
    return in_cell(row * columns_ + column);
  }
  /// The column or row of a coordinate; outside of the grid the nearest.
  [[nodiscard]] int column_of(double x) const { return clamped((x - low_.x()) / cell_, columns_); }
  [[nodiscard]] int row_of(double y) const { return clamped((y - low_.y()) / cell_, rows_); }

 private:
  [[nodiscard]] static int clamped(double index, int count);
  /// @param ends_of gives the two ends of an edge.
  template <typename Ends>
  void build(std::size_t count, Ends ends_of);
  template <typename Ends>
  void set_size(std::size_t count, Ends ends_of);
  template <typename Visit>
  void for_each_cell(const Point2& a, const Point2& b, Visit visit) const;

  Point2 low_ = Point2::Zero();
  double cell_ = 1.0;       ///< side of a cell, mm
  int columns_ = 1;         ///< one or more
  int rows_ = 1;            ///< one or more
  std::vector<int> first_;  ///< of each cell in `entries_`, and one more
  std::vector<int> entries_;
};

}  // namespace roomatlas::planar
