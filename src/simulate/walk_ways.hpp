// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/grid/raster.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

struct WalkOptions {
  double cell_m = 0.1;       ///< larger misses doors
  double clearance_m = 0.3;  ///< of one's middle from all that stands, less most of a cell
  double easy_m = 0.6;       ///< nearer to walls one goes only where one must
};

/// Where one can go in a world: the floor that hangs together with one place.
class WalkWays {
 public:
  WalkWays(const FloorPlan& world, const Point2& start, const WalkOptions& options);

  /// One of all places to walk on.
  /// @param share which, [0, 1)
  [[nodiscard]] std::optional<Point2> place(double share) const;
  /// A way of about this length; shorter where the floor ends. Empty where nobody can walk.
  /// @param share which of the ends that are that far away, [0, 1)
  [[nodiscard]] Polyline way_from(const Point2& from, double length_m, double share);
  /// The way to the nearest of some places, its corners alone. Empty where none is reached.
  [[nodiscard]] Polyline way_to_nearest(const Point2& from,
                                        const std::function<bool(const Point2&)>& is_goal);
  [[nodiscard]] bool is_walked(const Point2& at) const;
  /// All places, a cell apart, row by row.
  [[nodiscard]] std::vector<Point2> places() const;

 private:
  struct Visit {
    std::uint32_t search = 0;  ///< in which it was reached
    bool done = false;
    float cost_m = 0.0F;
    Cell from;
  };
  /// The cell of a place, or the nearest one beside it that can be walked on.
  [[nodiscard]] std::optional<Cell> cell_near(const Point2& at) const;
  /// Visits cells in the order of their distance from `start`, with that distance, until `visit`
  /// returns false (Dijkstra 1959).
  void search(const Cell& start, const std::function<bool(const Cell&, double)>& visit);
  [[nodiscard]] Polyline way_to(Cell cell, const Cell& start) const;
  [[nodiscard]] Polyline straightened(const Polyline& way) const;
  [[nodiscard]] double clearance_between(const Point2& from, const Point2& to) const;

  WalkOptions options_;
  CellFrame frame_;
  Raster<float> clearance_;  ///< metres, of the middle of each cell
  std::vector<Cell> cells_;  ///< that are walked on, row by row
  Raster<std::uint8_t> is_walked_;
  Raster<Visit> visits_;
  std::uint32_t search_ = 0;
};

}  // namespace roomatlas
