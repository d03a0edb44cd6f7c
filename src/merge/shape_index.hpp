// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <memory>
#include <vector>

namespace roomatlas::planar {

/// How often the ring runs around the point, counter-clockwise positive. Points on the ring may
/// go either way.
[[nodiscard]] int winding_number(const Ring& ring, const Point2& point);

/// Non-zero rule for the outer ring, and none of the holes (each under the same rule): the
/// orientation of rings does not matter.
[[nodiscard]] bool covers(const Polygon& shape, const Point2& point);

/// Finds the polygons over a point. Keeps references to the polygons: they must outlive it.
class ShapeIndex {
 public:
  explicit ShapeIndex(const std::vector<Polygon>& shapes);
  ~ShapeIndex();
  ShapeIndex(const ShapeIndex&) = delete;
  ShapeIndex& operator=(const ShapeIndex&) = delete;

  /// Indices of the shapes that cover the point, ascending.
  [[nodiscard]] std::vector<int> covering(const Point2& point) const;

 private:
  struct Tree;
  const std::vector<Polygon>& shapes_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace roomatlas::planar
