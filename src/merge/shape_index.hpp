// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <memory>
#include <vector>

namespace roomatlas::planar {

/// Finds polygons by their bounding boxes.
class ShapeIndex {
 public:
  explicit ShapeIndex(const std::vector<Polygon>& shapes);
  ~ShapeIndex();
  ShapeIndex(const ShapeIndex&) = delete;
  ShapeIndex& operator=(const ShapeIndex&) = delete;

  /// Indices of the shapes whose bounding boxes meet the box, ascending.
  [[nodiscard]] std::vector<int> near(const Box2& box) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace roomatlas::planar
