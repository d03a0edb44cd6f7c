// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "maps/plan_raster.hpp"

namespace roomatlas::io {

/// A driveable way; no points where there is none.
struct Way {
  Polyline line;             ///< from end to end, its bends between
  double length_m = 0.0;     ///< along it
  double clearance_m = 0.0;  ///< at its narrowest
};

/// The cells that are free for one room: its own, and those between rooms (door openings).
class RouteCells {
 public:
  static constexpr double kClearance_m = 0.15;  ///< of every cell that is driven over

  explicit RouteCells(const FloorPlan& plan);

  /// Goes on with one room of the plan.
  void enter(const PlanRoom& room);
  /// Whether a robot can stand there at all.
  [[nodiscard]] bool is_open(const Point2& point) const;
  /// The nearest open place within 2 m, or nothing.
  [[nodiscard]] std::optional<Point2> nearest_open(const Point2& point) const;
  /// The shortest way that keeps away from walls where there is room.
  [[nodiscard]] Way way(const Point2& from, const Point2& to) const;

 private:
  struct Cell {
    int x = 0;
    int y = 0;
  };
  [[nodiscard]] Cell cell_of(const Point2& point) const;
  [[nodiscard]] Point2 centre_of(const Cell& cell) const;
  [[nodiscard]] float clearance(const Cell& cell) const;
  [[nodiscard]] double clearance(const Segment2& line) const;
  /// The cheapest cells from one to another, without the two; nothing where there are none.
  [[nodiscard]] std::optional<std::vector<Cell>> cells_between(const Cell& from,
                                                               const Cell& to) const;
  [[nodiscard]] Way pulled(const std::vector<Cell>& cells, const Point2& from,
                           const Point2& to) const;

  PlanRaster map_;
  CellGrid<float> clearance_m_;  ///< to the nearest cell that is not free
  CellGrid<int> owner_;          ///< the room, by its place in the plan from 1; 0 between rooms
  const FloorPlan& plan_;
  int room_ = 0;  ///< that was entered
  Cell low_;      ///< the window around it
  Cell high_;     ///< just beyond
};

}  // namespace roomatlas::io
