// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas::testing_io {

/// How many of a world's parts a point lies in.
struct Covers {
  std::uint8_t rooms = 0;
  std::uint8_t doors = 0;
  std::uint8_t walls = 0;
  std::uint8_t furniture = 0;
  RoomId room = 0;  ///< the last of `rooms`
};

/// Calls `visit(polygon, mark)`, where `mark` notes in a Covers that the polygon is there.
inline void for_each_part(
    const FloorPlan& world,
    const std::function<void(const Polygon&, std::function<void(Covers&)>)>& visit) {
  for (const PlanRoom& room : world.rooms) {
    for (const Polygon& part : room.parts) {
      visit(part, [id = room.id](Covers& cell) { ++cell.rooms, cell.room = id; });
    }
  }
  for (const PlanDoor& door : world.doors)
    visit({door.opening, {}}, [](Covers& cell) { ++cell.doors; });
  for (const Polygon& wall : world.walls) visit(wall, [](Covers& cell) { ++cell.walls; });
  for (const Polygon& piece : outlines_of(world.furniture))
    visit(piece, [](Covers& cell) { ++cell.furniture; });
}

inline Covers covers_of(const FloorPlan& world, const Point2& point) {
  Covers covers;
  for_each_part(world, [&](const Polygon& part, const auto& mark) {
    if (contains(part, point)) mark(covers);
  });
  return covers;
}

/// A world sampled at points 5 cm apart, by brute force.
class WorldRaster {
 public:
  using Cell = Covers;

  explicit WorldRaster(const FloorPlan& world) {
    Box2 box;
    for (const Polygon& wall : world.walls) {
      for (const Point2& corner : wall.outer) box.extend(corner);
    }
    // the offset keeps the points off the edges of walls
    origin_ = box.min + Point2::Constant(0.026) - Point2::Constant(5 * kStep_m);
    columns_ = static_cast<int>(box.size().x() / kStep_m) + 10;
    rows_ = static_cast<int>(box.size().y() / kStep_m) + 10;
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for_each_part(world, [&](const Polygon& part, const auto& mark) {
      for_each_cell_within(bounds(part.outer), [&](int column, int row) {
        if (contains(part, point_at(column, row))) mark(cells_[index(column, row)]);
      });
    });
  }

  [[nodiscard]] std::int64_t count(const std::function<bool(const Cell&)>& holds) const {
    return std::count_if(cells_.begin(), cells_.end(), holds);
  }

  /// Visits every cell that a disc can reach from a point without touching walls or furniture.
  void flood(const Point2& start, double clearance_m,
             const std::function<void(const Cell&)>& visit) const {
    std::vector<bool> closed = cells_near_obstacles(clearance_m);
    const Point2 first = (start - origin_) / kStep_m;
    std::vector<std::pair<int, int>> open = {
        {static_cast<int>(std::lround(first.x())), static_cast<int>(std::lround(first.y()))}};
    while (!open.empty()) {
      const auto [column, row] = open.back();
      open.pop_back();
      if (!is_inside(column, row) || closed[index(column, row)]) continue;
      closed[index(column, row)] = true;
      visit(cells_[index(column, row)]);
      open.insert(open.end(),
                  {{column + 1, row}, {column - 1, row}, {column, row + 1}, {column, row - 1}});
    }
  }

 private:
  static constexpr double kStep_m = 0.05;

  [[nodiscard]] bool is_inside(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns_ && row < rows_;
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] Point2 point_at(int column, int row) const {
    return origin_ + kStep_m * Point2(column, row);
  }

  void for_each_cell_within(const Box2& box, const std::function<void(int, int)>& visit) const {
    const Point2 low = (box.min - origin_) / kStep_m;
    const Point2 high = (box.max - origin_) / kStep_m;
    for (int row = static_cast<int>(low.y()); row <= static_cast<int>(high.y()) + 1; ++row) {
      for (int column = static_cast<int>(low.x()); column <= static_cast<int>(high.x()) + 1;
           ++column) {
        if (is_inside(column, row)) visit(column, row);
      }
    }
  }

  [[nodiscard]] std::vector<bool> cells_near_obstacles(double clearance_m) const {
    std::vector<bool> near(cells_.size(), false);
    const int reach = static_cast<int>(clearance_m / kStep_m);
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const Cell& cell = cells_[index(column, row)];
        if (cell.walls + cell.furniture == 0) continue;
        for (int dy = -reach; dy <= reach; ++dy) {
          for (int dx = -reach; dx <= reach; ++dx) {
            if (std::hypot(dx, dy) * kStep_m > clearance_m || !is_inside(column + dx, row + dy))
              continue;
            near[index(column + dx, row + dy)] = true;
          }
        }
      }
    }
    return near;
  }

  Point2 origin_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace roomatlas::testing_io
