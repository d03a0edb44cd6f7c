// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <memory>
#include <vector>

namespace roomatlas {

/// The edges of rings in an R-tree, to find the nearest.
class SegmentIndex {
 public:
  explicit SegmentIndex(const std::vector<Ring>& rings);
  ~SegmentIndex();

  [[nodiscard]] bool empty() const { return segments_.empty(); }
  /// Distance to the nearest edge, exactly; infinity without edges.
  [[nodiscard]] double distance(const Point2& point) const;

 private:
  struct Tree;

  std::vector<Segment2> segments_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace roomatlas
