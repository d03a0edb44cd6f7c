// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace roomatlas::drawing {

/// Segments by the cells that their boxes meet, so that those near a place are found at once.
class SegmentGrid {
 public:
  explicit SegmentGrid(double cell_m) : cell_m_(cell_m) {}

  void add(const Segment2& segment);
  [[nodiscard]] const std::vector<Segment2>& segments() const { return segments_; }
  /// Numbers of the segments in the cells that the box meets, ascending.
  [[nodiscard]] std::vector<std::size_t> near(const Box2& box) const;

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;
  template <typename Visit>
  void for_each_cell(const Box2& box, Visit visit) const;

  double cell_m_;
  std::vector<Segment2> segments_;
  std::map<Cell, std::vector<std::size_t>> cells_;
};

/// The box of a segment, grown by `margin` on all sides.
[[nodiscard]] Box2 box_around(const Segment2& segment, double margin);

}  // namespace roomatlas::drawing
