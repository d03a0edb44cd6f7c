// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_building_layout.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/simulate/random_building.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

namespace roomatlas {
namespace {

using namespace random_building_layout;

Ring ring_of(const Box2& box) {
  return {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
}

PlanRoom room_of(const Space& space) {
  PlanRoom room;
  room.id = space.id;
  room.name = std::to_string(space.id);
  room.kind = space.kind;
  room.parts = {{ring_of(space.box), {}}};
  room.area_m2 = space.box.size().prod();
  room.label_point = (space.box.min + space.box.max) / 2.0;
  return room;
}

PlanDoor door_of(const LaidDoor& door, std::int64_t id) {
  const Pose2& pivot = door.opening.world_from_pivot;
  const Point2 half(0.0, door.opening.width_m / 2.0);
  const Point2 depth(kWallM / 2.0, 0.0);
  PlanDoor result;
  result.id = id;
  result.jambs = {pivot * half, pivot * Point2(-half)};
  result.width_m = door.opening.width_m;
  result.opening = {pivot * Point2(half - depth), pivot * Point2(-half - depth),
                    pivot * Point2(depth - half), pivot * Point2(half + depth)};
  std::tie(result.room_a, result.room_b) = std::minmax(door.from, door.opening.beyond);
  return result;
}

/// A wall along x or y, broken at doors.
struct WallLine {
  Point2 from;  ///< mid-line
  Point2 to;
};

void add_wall(const WallLine& line, const std::vector<LaidOpening>& openings,
              std::vector<Polygon>& walls) {
  const Point2 unit = (line.to - line.from).normalized();
  const Point2 left(-unit.y(), unit.x());
  const double length_m = (line.to - line.from).norm();
  std::vector<std::pair<double, double>> gaps;
  for (const LaidOpening& opening : openings) {
    const Point2 offset = opening.world_from_pivot.position() - line.from;
    const double at_m = offset.dot(unit);
    if (std::abs(offset.dot(left)) > kWallM / 2.0 || at_m < 0.0 || at_m > length_m) continue;
    gaps.emplace_back(at_m - opening.width_m / 2.0, at_m + opening.width_m / 2.0);
  }
  std::sort(gaps.begin(), gaps.end());
  gaps.emplace_back(length_m, length_m);
  double from_m = 0.0;
  for (const auto& [gap_from_m, gap_to_m] : gaps) {
    const Point2 a = line.from + from_m * unit;
    const Point2 b = line.from + gap_from_m * unit;
    const Point2 half = kWallM / 2.0 * left;
    if (gap_from_m > from_m) walls.push_back({{a - half, b - half, b + half, a + half}, {}});
    from_m = gap_to_m;
  }
}

/// The walls of a block: the long ones from end to end, between them the cross walls. A wall
/// between two blocks belongs to the southern or western one.
std::vector<Polygon> walls_of(const Block& block, const Layout& layout) {
  std::vector<LaidOpening> openings;
  for (const Space& space : block.spaces) {
    openings.insert(openings.end(), space.openings.begin(), space.openings.end());
  }
  const bool is_west_end = !layout.index_at(block.strip, block.column - 1);
  const Box2& corridor = block.corridor().box;
  const double half = kWallM / 2.0;
  const double low_x = corridor.min.x() - (is_west_end ? kWallM : 0.0);
  const double high_x = corridor.max.x() + kWallM;
  std::vector<Polygon> walls;
  const auto along_x = [&](double y) { add_wall({{low_x, y}, {high_x, y}}, openings, walls); };
  const auto across = [&](double x, const Box2& row) {
    add_wall({{x, row.min.y()}, {x, row.max.y()}}, openings, walls);
  };
  const auto ends_of = [&](const Box2& row) {
    if (is_west_end) across(corridor.min.x() - half, row);
    across(corridor.max.x() + half, row);
  };
  along_x(corridor.min.y() - half);
  along_x(corridor.max.y() + half);
  ends_of(corridor);
  for (const auto& link : {block.south_link, block.north_link}) {
    if (!link) continue;
    const Box2& row = block.spaces[*link].box;
    const bool is_north = link == block.north_link;
    if (is_north || block.strip == 0) along_x(is_north ? row.max.y() + half : row.min.y() - half);
    ends_of(row);
    for (const Space& space : block.spaces) {
      const bool is_in_row = space.box.min.y() == row.min.y();
      if (is_in_row && space.box.max.x() < corridor.max.x() - half) {
        across(space.box.max.x() + half, row);
      }
    }
  }
  return walls;
}

FloorPlan plan_of(const Block& block, const Layout& layout, std::int64_t& doors) {
  FloorPlan plan;
  for (const Space& space : block.spaces) plan.rooms.push_back(room_of(space));
  for (const LaidDoor& door : block.doors) plan.doors.push_back(door_of(door, ++doors));
  plan.walls = walls_of(block, layout);
  return plan;
}

}  // namespace

void random_building_plan(const RandomBuildingOptions& options,
                          const std::function<void(const FloorPlan&)>& sink) {
  if (options.rooms < 1) throw UsageError("a random building needs at least one room");
  const Layout layout(options.rooms, options.seed);
  std::int64_t doors = 0;
  for (std::int64_t index = 0; index < layout.blocks(); ++index) {
    sink(plan_of(layout.block(index), layout, doors));
  }
}

FloorPlan random_building_plan(const RandomBuildingOptions& options) {
  FloorPlan whole;
  whole.title = "Random building of " + std::to_string(options.rooms) + " rooms";
  random_building_plan(options, [&](const FloorPlan& part) {
    whole.rooms.insert(whole.rooms.end(), part.rooms.begin(), part.rooms.end());
    whole.doors.insert(whole.doors.end(), part.doors.begin(), part.doors.end());
    whole.walls.insert(whole.walls.end(), part.walls.begin(), part.walls.end());
  });
  return whole;
}

}  // namespace roomatlas
