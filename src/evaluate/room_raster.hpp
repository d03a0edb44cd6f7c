// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/floor_plan.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

namespace roomatlas {

/// A square of the lattice through the origin: [column, column + 1) x [row, row + 1) steps.
struct LatticeCell {
  std::int64_t column = 0;
  std::int64_t row = 0;
  [[nodiscard]] bool operator==(const LatticeCell&) const = default;
  [[nodiscard]] bool operator<(const LatticeCell& other) const {
    return std::tie(column, row) < std::tie(other.column, other.row);
  }
};

/// The squares whose middle lies in a polygon (even-odd), row by row.
[[nodiscard]] std::vector<LatticeCell> cells_in(const Polygon& polygon, double step_m);

/// A plan's rooms as a lattice of points: which room each point lies in. Quick where exact areas
/// would be asked for thousands of times.
class RoomRaster {
 public:
  RoomRaster(const FloorPlan& plan, double step_m);

  /// The index of the room at a point, or -1.
  [[nodiscard]] int room_at(const Point2& point) const;
  /// The lattice points inside rooms, room after room.
  [[nodiscard]] const std::vector<std::vector<Point2>>& points() const { return points_; }
  [[nodiscard]] std::size_t rooms() const { return points_.size(); }

 private:
  void fill(const PlanRoom& room, int index);

  [[nodiscard]] std::optional<std::size_t> slot(const LatticeCell& cell) const;

  double step_m_;
  LatticeCell low_;  ///< of the box that holds all rooms
  std::int64_t columns_ = 0;
  std::int64_t rows_ = 0;
  std::vector<int> labels_;
  std::vector<std::vector<Point2>> points_;
};

/// The centre of points; the origin without points.
[[nodiscard]] Point2 centre_of(const std::vector<Point2>& points);

}  // namespace roomatlas
