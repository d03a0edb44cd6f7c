// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/merge/floor_plan.hpp"

#include <cstddef>
#include <vector>

namespace roomatlas {

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

  double step_m_;
  Point2 origin_ = Point2::Zero();
  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> labels_;
  std::vector<std::vector<Point2>> points_;
};

/// The centre of points; the origin without points.
[[nodiscard]] Point2 centre_of(const std::vector<Point2>& points);

}  // namespace roomatlas
