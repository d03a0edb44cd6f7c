// SPDX-License-Identifier: GPL-3.0-or-later
#include "segment_grid.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::drawing {

Box2 box_around(const Segment2& segment, double margin) {
  Box2 box;
  box.extend(segment.a);
  box.extend(segment.b);
  return {box.min - Point2::Constant(margin), box.max + Point2::Constant(margin)};
}

template <typename Visit>
void SegmentGrid::for_each_cell(const Box2& box, Visit visit) const {
  const auto cell = [&](double value) {
    return static_cast<std::int64_t>(std::floor(value / cell_m_));
  };
  for (std::int64_t x = cell(box.min.x()); x <= cell(box.max.x()); ++x) {
    for (std::int64_t y = cell(box.min.y()); y <= cell(box.max.y()); ++y) visit(Cell(x, y));
  }
}

void SegmentGrid::add(const Segment2& segment) {
  if (!segment.a.allFinite() || !segment.b.allFinite()) return;
  for_each_cell(box_around(segment, 0.0),
                [&](const Cell& cell) { cells_[cell].push_back(segments_.size()); });
  segments_.push_back(segment);
}

std::vector<std::size_t> SegmentGrid::near(const Box2& box) const {
  std::vector<std::size_t> found;
  for_each_cell(box, [&](const Cell& cell) {
    const auto entry = cells_.find(cell);
    if (entry != cells_.end())
      found.insert(found.end(), entry->second.begin(), entry->second.end());
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace roomatlas::drawing
