// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "roomatlas/core/floored.hpp"
#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

/// A cell of a square grid whose frame is the ASR's: cell (0, 0) covers [0, cell) x [0, cell).
struct Cell {
  int x = 0;
  int y = 0;
  [[nodiscard]] bool operator==(const Cell&) const = default;
};

/// A number of its own for each cell, for hash tables.
[[nodiscard]] inline std::int64_t key_of(const Cell& cell) {
  return (static_cast<std::int64_t>(cell.x) << 32) ^ static_cast<std::uint32_t>(cell.y);
}

[[nodiscard]] inline double distance_cells(const Cell& a, const Cell& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// The one place where metres become cells and cells metres.
struct CellFrame {
  double cell_m = 0.1;  ///< side of a cell (paper IV: 10 cm)

  [[nodiscard]] Cell cell_of(const Point2& point) const {
    return {static_cast<int>(floored(point.x() / cell_m)),
            static_cast<int>(floored(point.y() / cell_m))};
  }
  [[nodiscard]] Point2 center_of(const Cell& cell) const {
    return {(cell.x + 0.5) * cell_m, (cell.y + 0.5) * cell_m};
  }
};

/// Visits the cells of the line from `from` to `to`, both included, in order (Bresenham 1965, the
/// paper's line function Gamma, III.B). `visit` returns false to stop. The last `but` cells are
/// left out: with 2, the end and what touches it. Each step goes along the longer side, so that
/// as many cells are left as steps, and without a branch, since rays go through millions of cells.
template <typename Visit>
void for_each_cell_on_line(Cell from, const Cell& to, Visit visit, int but = 0) {
  const int dx = std::abs(to.x - from.x);
  const int dy = std::abs(to.y - from.y);
  const int step_x = from.x < to.x ? 1 : -1;
  const int step_y = from.y < to.y ? 1 : -1;
  const bool is_flat = dx >= dy;
  const Cell along = is_flat ? Cell{step_x, 0} : Cell{0, step_y};
  const Cell across = is_flat ? Cell{0, step_y} : Cell{step_x, 0};
  const int longer = std::max(dx, dy);
  const int shorter = std::min(dx, dy);
  int error = longer - shorter;
  for (int left = longer; left >= but && visit(from); --left) {
    const int aside = -static_cast<int>(2 * error <= longer);  // all bits, or none
    error += (longer & aside) - shorter;
    from.x += along.x + (across.x & aside);
    from.y += along.y + (across.y & aside);
  }
}

/// A rectangle of cells, `min` included, `max` excluded.
struct CellBox {
  Cell min;
  Cell max;

  [[nodiscard]] int width() const { return max.x - min.x; }
  [[nodiscard]] int height() const { return max.y - min.y; }
  [[nodiscard]] bool contains(const Cell& cell) const {
    return cell.x >= min.x && cell.x < max.x && cell.y >= min.y && cell.y < max.y;
  }
  [[nodiscard]] std::size_t index_of(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y - min.y) * static_cast<std::size_t>(width()) +
           static_cast<std::size_t>(cell.x - min.x);
  }
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
  }
};

/// Visits the cells of a box row by row, as the paper's loops do.
template <typename Visit>
void for_each_cell(const CellBox& box, Visit visit) {
  for (int y = box.min.y; y < box.max.y; ++y) {
    for (int x = box.min.x; x < box.max.x; ++x) visit(Cell{x, y});
  }
}

}  // namespace roomatlas
