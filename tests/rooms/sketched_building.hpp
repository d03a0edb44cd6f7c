// SPDX-License-Identifier: GPL-3.0-or-later
// Buildings drawn from boxes in metres, as a mission that saw everything would have mapped them.
#pragma once

#include <vector>

#include "roomatlas/rooms/building_grid.hpp"
#include "sketched_drive.hpp"

namespace roomatlas::test {

class SketchedBuilding {
 public:
  /// Free space of a size, in walls of 0.2 m.
  SketchedBuilding(double width_m, double depth_m) : width_m_(width_m), depth_m_(depth_m) {
    box(-0.2, -0.2, width_m + 0.2, 0.0);
    box(-0.2, depth_m, width_m + 0.2, depth_m + 0.2);
    box(-0.2, 0.0, 0.0, depth_m);
    box(width_m, 0.0, width_m + 0.2, depth_m);
  }
  /// An obstacle that fills a box: a wall, furniture.
  void box(double min_x, double min_y, double max_x, double max_y) {
    boxes_.push_back({{min_x, min_y}, {max_x, max_y}});
  }
  /// The robot drives from point to point, a pose each 0.1 m.
  void drive(const std::vector<Point2>& points) { add_drive(points, path_); }

  [[nodiscard]] const std::vector<Pose2>& path() const { return path_; }

  /// Every obstacle cell was hit ten times, every other cell of the building passed ten times.
  [[nodiscard]] ReflectionMap map() const {
    ReflectionMap map(kCellM);
    const CellFrame& frame = map.frame();
    for_each_cell(
        {frame.cell_of({-0.15, -0.15}), frame.cell_of({width_m_ + 0.35, depth_m_ + 0.35})},
        [&](const Cell& cell) {
          const Point2 at = frame.center_of(cell);
          const bool is_hit = is_obstacle(at);
          const Point2 off(0.3, 0.0);  // a hit takes no pass from its neighbours
          for (int i = 0; i < 10; ++i) {
            map.add_sweep({{{is_hit ? at - off : at, at}, is_hit}});
          }
        });
    return map;
  }
  [[nodiscard]] BuildingGrid grid(const BuildingGridOptions& options = {}) const {
    return building_grid(map(), SensorKind::laser, path_, {}, options);
  }

 private:
  static constexpr double kCellM = 0.1;

  [[nodiscard]] bool is_obstacle(const Point2& at) const {
    for (const Segment2& box : boxes_) {
      if ((at.array() > box.a.array()).all() && (at.array() < box.b.array()).all()) return true;
    }
    return false;
  }

  double width_m_;
  double depth_m_;
  std::vector<Segment2> boxes_;
  std::vector<Pose2> path_;
};

/// Two rooms of 4 m x 5 m side by side, joined by a door of 0.9 m at (4.1, 2.45).
inline SketchedBuilding two_rooms() {
  SketchedBuilding building(8.2, 5.0);
  building.box(4.0, 0.0, 4.2, 2.0);
  building.box(4.0, 2.9, 4.2, 5.0);
  return building;
}

}  // namespace roomatlas::test
