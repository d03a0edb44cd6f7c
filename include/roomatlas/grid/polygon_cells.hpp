// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/grid/cells.hpp"

namespace roomatlas {

/// Visits the cells of the box whose middle lies in the polygon (even-odd), row by row. Costs what
/// the polygon's edges and cells are, not their product.
template <typename Visit>
void for_each_cell_in(const Polygon& polygon, const CellFrame& frame, const CellBox& box,
                      Visit visit) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(box.height()));
  const auto add = [&](const Point2& a, const Point2& b) {
    const Point2& low = a.y() < b.y() ? a : b;
    const Point2& high = a.y() < b.y() ? b : a;
    const double first = std::ceil(low.y() / frame.cell_m - 0.5);
    const double last = std::ceil(high.y() / frame.cell_m - 0.5) - 1.0;
    const int from = static_cast<int>(std::max<double>(first, box.min.y));
    const int to = static_cast<int>(std::min<double>(last, box.max.y - 1));
    for (int y = from; y <= to; ++y) {
      const double share = (frame.center_of({0, y}).y() - low.y()) / (high.y() - low.y());
      crossings[static_cast<std::size_t>(y - box.min.y)].push_back(low.x() +
                                                                   share * (high.x() - low.x()));
    }
  };
  const auto add_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()]);
  };
  add_ring(polygon.outer);
  for (const Ring& hole : polygon.holes) add_ring(hole);
  for (int y = box.min.y; y < box.max.y; ++y) {
    auto& row = crossings[static_cast<std::size_t>(y - box.min.y)];
    std::sort(row.begin(), row.end());
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
      const int from = static_cast<int>(std::ceil(row[i] / frame.cell_m - 0.5));
      const int to = static_cast<int>(std::ceil(row[i + 1] / frame.cell_m - 0.5));
      for (int x = std::max(from, box.min.x); x < std::min(to, box.max.x); ++x) visit(Cell{x, y});
    }
  }
}

/// The cells of the box whose middle may lie nearer than `radius_m` to the points.
[[nodiscard]] inline CellBox cells_around(const Ring& points, double radius_m,
                                          const CellFrame& frame, const CellBox& box) {
  const Box2 bound = bounds(points);
  const Cell low = frame.cell_of(bound.min - Point2::Constant(radius_m));
  const Cell high = frame.cell_of(bound.max + Point2::Constant(radius_m));
  return {{std::max(low.x, box.min.x), std::max(low.y, box.min.y)},
          {std::min(high.x + 1, box.max.x), std::min(high.y + 1, box.max.y)}};
}

}  // namespace roomatlas
