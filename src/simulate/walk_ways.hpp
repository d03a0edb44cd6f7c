// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/grid/raster.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// Where people can walk in a world: the floor that hangs together with one place.
class WalkWays {
 public:
  WalkWays(const FloorPlan& world, const Point2& start);

  /// One of all places to walk on.
  /// @param share which, [0, 1)
  [[nodiscard]] std::optional<Point2> place(double share) const;
  /// A way of about this length; shorter where the floor ends. Empty where nobody can walk.
  /// @param share which of the ends that are that far away, [0, 1)
  [[nodiscard]] Polyline way_from(const Point2& from, double length_m, double share);
  [[nodiscard]] bool is_walked(const Point2& at) const;

 private:
  struct Visit {
    std::uint32_t search = 0;  ///< in which it was reached
    bool done = false;
    float cost_m = 0.0F;
    Cell from;
  };
  /// The cell of a place, or the nearest one beside it that can be walked on.
  [[nodiscard]] std::optional<Cell> cell_near(const Point2& at) const;
  /// Cells in the order of their distance, up to `length_m` (Dijkstra 1959).
  [[nodiscard]] std::vector<Cell> cells_within(const Cell& start, double length_m);

  CellFrame frame_;
  Raster<float> clearance_;  ///< metres, of the middle of each cell
  std::vector<Cell> cells_;  ///< that are walked on, row by row
  Raster<std::uint8_t> is_walked_;
  Raster<Visit> visits_;
  std::uint32_t search_ = 0;
};

}  // namespace roomatlas
