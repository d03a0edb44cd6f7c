// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/locate/floor_sketch.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>

#include "roomatlas/grid/cells.hpp"

namespace roomatlas {
namespace {

constexpr double kWallCellM = 0.1;
constexpr int kSectors = 8;
constexpr int kFreeCells =
    2;  // of the four shape cells in one of the sketch; one alone is a glimpse
constexpr double kMinHits = 2.0;  // of a face: hit once it may be anything

/// Of a wall point: its cell and the sector of its normal. Ordered, so that a sketch is the same
/// however it was put together.
using WallKey = std::tuple<int, int, int>;

WallKey key_of_wall(const ScanPoint& point) {
  const Cell cell = CellFrame{kWallCellM}.cell_of(point.position);
  const double turn = std::atan2(point.normal.y(), point.normal.x()) / (2.0 * kPi) + 0.5;
  return {cell.y, cell.x, static_cast<int>(turn * kSectors) % kSectors};
}

}  // namespace

FloorSketch sketch_of(std::span<const AsrShape* const> shapes, const Placement& placement) {
  std::map<WallKey, ScanPoint> walls;
  std::map<std::pair<int, int>, int> seen_free;
  FloorSketch sketch;
  for (const AsrShape* shape : shapes) {
    const Pose2& pose = placement.at(shape->id);
    const PointTransform place(pose);
    const PointTransform turn(Pose2{0.0, 0.0, pose.theta_rad});
    for (const ScanPoint& point : shape->points) {
      const ScanPoint placed{place * point.position, turn * point.normal, true};
      walls.try_emplace(key_of_wall(placed), placed);
    }
    shape->map.for_each_known_cell(
        kMinHits,
        [&](const Cell& cell) {
          const Point2 center = place * shape->map.frame().center_of(cell);
          const Cell at = floor_cells().cell_of(center);
          ++seen_free[{at.y, at.x}];
        },
        [](const Cell&) {});
    for (const Point2& at : shape->path) sketch.path.push_back(place * at);
  }
  for (const auto& [key, point] : walls) sketch.walls.push_back(point);
  for (const auto& [at, count] : seen_free) {
    if (count < kFreeCells) continue;
    sketch.floor.push_back(floor_cells().center_of({at.second, at.first}));
  }
  return sketch;
}

FloorSketch moved(FloorSketch sketch, const Pose2& to_from_sketch) {
  const PointTransform place(to_from_sketch);
  const PointTransform turn(Pose2{0.0, 0.0, to_from_sketch.theta_rad});
  for (ScanPoint& wall : sketch.walls) wall = {place * wall.position, turn * wall.normal, true};
  for (Point2& at : sketch.floor) at = place * at;
  for (Point2& at : sketch.path) at = place * at;
  return sketch;
}

}  // namespace roomatlas
