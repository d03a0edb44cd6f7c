// SPDX-License-Identifier: GPL-3.0-or-later
#include "segment_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace roomatlas::planar {
namespace {

constexpr double kCellsPerEdge = 6.0;   // at most: memory
constexpr double kCellPerLength = 0.6;  // of the mean edge: an edge passes through two or three
constexpr double kMargin = 1e-6;        // of a cell, for rounding where an edge enters a column

}  // namespace

int SegmentGrid::clamped(double index, int count) {
  return static_cast<int>(std::clamp(index, 0.0, static_cast<double>(count - 1)));
}

template <typename Ends>
void SegmentGrid::set_size(std::size_t count, Ends ends_of) {
  if (count == 0) return;
  Box2 box;
  double length = 0.0;
  for (std::size_t e = 0; e < count; ++e) {
    const auto [a, b] = ends_of(e);
    box.extend(a);
    box.extend(b);
    length += (b - a).norm();
  }
  low_ = box.min;
  const auto edges = static_cast<double>(count);
  const Point2 size = box.size();
  cell_ = std::max({kCellPerLength * length / edges,
                    std::sqrt(size.x() * size.y() / (kCellsPerEdge * edges)),
                    size.maxCoeff() / (kCellsPerEdge * edges)});
  columns_ = static_cast<int>(size.x() / cell_) + 1;
  rows_ = static_cast<int>(size.y() / cell_) + 1;
}

/// Column by column, the rows between where the edge enters and where it leaves.
template <typename Visit>
void SegmentGrid::for_each_cell(const Point2& a, const Point2& b, Visit visit) const {
  const Point2& left = a.x() <= b.x() ? a : b;
  const Point2& right = a.x() <= b.x() ? b : a;
  const int first = column_of(left.x());
  const int last = column_of(right.x());
  const double rise = last > first ? (right.y() - left.y()) / (right.x() - left.x()) : 0.0;
  const double margin = kMargin * cell_;
  for (int column = first; column <= last; ++column) {
    const double enter = low_.x() + column * cell_;
    const double from = column == first ? left.y() : left.y() + rise * (enter - left.x());
    const double to = column == last ? right.y() : left.y() + rise * (enter + cell_ - left.x());
    const int low = row_of(std::min(from, to) - margin);
    const int high = row_of(std::max(from, to) + margin);
    for (int row = low; row <= high; ++row)
      visit(static_cast<std::size_t>(row * columns_ + column));
  }
}

template <typename Ends>
void SegmentGrid::build(std::size_t count, Ends ends_of) {
  set_size(count, ends_of);
  first_.assign(static_cast<std::size_t>(cell_count()) + 1, 0);
  for (std::size_t e = 0; e < count; ++e) {
    const auto [a, b] = ends_of(e);
    for_each_cell(a, b, [&](std::size_t c) { ++first_[c]; });
  }
  int sum = 0;
  for (int& first : first_) first = sum += first;
  entries_.resize(static_cast<std::size_t>(sum));
  for (std::size_t e = count; e-- > 0;) {
    const auto [a, b] = ends_of(e);
    for_each_cell(a, b, [&](std::size_t c) {
      entries_[static_cast<std::size_t>(--first_[c])] = static_cast<int>(e);
    });
  }
}

SegmentGrid::SegmentGrid(const EdgeSet& set, const std::vector<int>& of) {
  build(of.size(), [&](std::size_t i) {
    const RingEdge& edge = set.edges[static_cast<std::size_t>(of[i])];
    return std::pair<const Point2&, const Point2&>(set.point(edge.from), set.point(edge.to));
  });
}

SegmentGrid::SegmentGrid(const std::vector<Point2>& points_mm,
                         const std::vector<int>& ends_of_edges) {
  build(ends_of_edges.size() / 2, [&](std::size_t e) {
    return std::pair<const Point2&, const Point2&>(
        points_mm[static_cast<std::size_t>(ends_of_edges[2 * e])],
        points_mm[static_cast<std::size_t>(ends_of_edges[2 * e + 1])]);
  });
}

}  // namespace roomatlas::planar
