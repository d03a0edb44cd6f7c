// SPDX-License-Identifier: GPL-3.0-or-later
#include "merge/noisy_building.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace roomatlas::bench {
namespace {

constexpr double kVertexEvery_m = 0.6;
constexpr double kVertexNoise_m = 0.02;
constexpr double kPositionNoise_m = 0.03;
constexpr double kHeadingNoise_deg = 0.5;
constexpr double kWall_m = 0.12;
constexpr double kCorridorHalf_m = 11.0;  // the outside of the ring
constexpr double kCorridorWidth_m = 2.0;
constexpr double kRoomWidth_m = 5.0;
constexpr double kRoomDepth_m = 4.0;
constexpr double kLink_m = 3.0;
constexpr double kDoor_m = 0.9;
constexpr double kDoorReach_m = 0.25;  // of an opening, beyond the wall on each side
constexpr double kPillarShare = 1.0 / 3.0;
constexpr double kBuildingTurn_deg = 10.0;
constexpr int kRoomsInBlock = 21;
constexpr double kBlockHalf_m = kCorridorHalf_m + kWall_m + kRoomDepth_m;
constexpr double kPitch_m = 2.0 * (kBlockHalf_m + kWall_m) + kLink_m;

Point2 on_grid(const Point2& point_m) {
  return {std::round(point_m.x() * 1000.0) / 1000.0, std::round(point_m.y() * 1000.0) / 1000.0};
}

Ring rectangle(const Point2& low, const Point2& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

Ring square(double half_m) { return rectangle({-half_m, -half_m}, {half_m, half_m}); }

class Builder {
 public:
  Builder(std::int64_t rooms, std::uint64_t seed) : left_(rooms), random_(seed) {}

  NoisyBuilding build();

 private:
  [[nodiscard]] double normal(double sigma) {
    const double value = std::normal_distribution<double>(0.0, sigma)(random_);
    return std::clamp(value, -2.5 * sigma, 2.5 * sigma);
  }
  /// The corners and points between them, each moved a little.
  [[nodiscard]] Ring drawn(const Ring& corners);
  RoomId add_room(const Pose2& building_from_room, const Polygon& true_shape);
  void add_door(const Pose2& building_from_door, RoomId room, std::optional<RoomId> other);
  void add_side(const Pose2& building_from_side, RoomId corridor);
  void add_block(const Pose2& building_from_block);

  std::int64_t left_;
  std::mt19937_64 random_;
  NoisyBuilding building_;
};

Ring Builder::drawn(const Ring& corners) {
  Ring ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2& from = corners[i];
    const Point2& to = corners[(i + 1) % corners.size()];
    const int steps =
        std::max(1, static_cast<int>(std::lround((to - from).norm() / kVertexEvery_m)));
    for (int step = 0; step < steps; ++step) {
      const Point2 at = from + (to - from) * step / steps;
      ring.push_back(at + Point2(normal(kVertexNoise_m), normal(kVertexNoise_m)));
    }
  }
  return ring;
}

/// @return its id; 0 when there are rooms enough.
RoomId Builder::add_room(const Pose2& building_from_room, const Polygon& true_shape) {
  if (left_ == 0) return 0;
  --left_;
  Polygon shape;
  shape.outer = drawn(true_shape.outer);
  for (const Ring& hole : true_shape.holes) shape.holes.push_back(drawn(hole));
  const Pose2 noise{normal(kPositionNoise_m), normal(kPositionNoise_m),
                    radians(normal(kHeadingNoise_deg))};
  Polygon placed = transformed(building_from_room * noise, shape);
  for (Point2& point : placed.outer) point = on_grid(point);
  for (Ring& hole : placed.holes) {
    for (Point2& point : hole) point = on_grid(point);
  }
  const auto id = static_cast<std::int64_t>(building_.outlines.size()) + 1;
  building_.outlines.push_back({id, id, std::move(placed)});
  return id;
}

/// @param building_from_door its x axis leads through the door.
/// @param room on one side; 0: there is no door.
void Builder::add_door(const Pose2& building_from_door, RoomId room, std::optional<RoomId> other) {
  if (room == 0) return;
  const double half = kDoor_m / 2.0;
  const double reach = kWall_m / 2.0 + kDoorReach_m;
  building_.doors.push_back(door_between({on_grid(building_from_door * Point2(0.0, -half)),
                                          on_grid(building_from_door * Point2(0.0, half))},
                                         room, other));
  Ring opening = transformed(building_from_door, rectangle({-reach, -half}, {reach, half}));
  for (Point2& point : opening) point = on_grid(point);
  building_.openings.push_back({std::move(opening), {}});
}

/// Four rooms along one side of the corridor, each with a door to it.
/// @param building_from_side x along the side, y outwards, the origin in the corridor's middle.
void Builder::add_side(const Pose2& building_from_side, RoomId corridor) {
  const double pitch = kRoomWidth_m + kWall_m;
  for (int i = 0; i < 4; ++i) {
    const Point2 middle((i - 1.5) * pitch, kCorridorHalf_m + kWall_m + kRoomDepth_m / 2.0);
    const Point2 half(kRoomWidth_m / 2.0, kRoomDepth_m / 2.0);
    Polygon room{rectangle(-half, half), {}};
    if (std::bernoulli_distribution(kPillarShare)(random_)) room.holes.push_back(square(0.3));
    const RoomId id = add_room(building_from_side * Pose2{middle.x(), middle.y(), 0.0}, room);
    const Pose2 side_from_door{middle.x(), kCorridorHalf_m + kWall_m / 2.0, radians(90.0)};
    add_door(building_from_side * side_from_door, id, corridor);
  }
}

void Builder::add_block(const Pose2& block) {
  const RoomId corridor =
      add_room(block, {square(kCorridorHalf_m), {square(kCorridorHalf_m - kCorridorWidth_m)}});
  for (int side = 0; side < 4; ++side) {
    add_side(block * Pose2{0.0, 0.0, radians(90.0 * side)}, corridor);
  }
  add_room(block, {square(4.0), {square(2.0)}});
  add_room(block, {square(1.2), {}});
  for (const double turn_deg : {0.0, 90.0}) {  // links to the next block in x and in y
    const Pose2 link = block * Pose2{0.0, 0.0, radians(turn_deg)} *
                       Pose2{kPitch_m / 2.0, (kRoomWidth_m + kWall_m) / 2.0, 0.0};
    const RoomId id = add_room(link, {rectangle({-kLink_m / 2.0, -1.0}, {kLink_m / 2.0, 1.0}), {}});
    const double wall_x = (kLink_m + kWall_m) / 2.0;
    add_door(link * Pose2{-wall_x, 0.0, 0.0}, id, {});
    add_door(link * Pose2{wall_x, 0.0, 0.0}, id, {});
  }
}

NoisyBuilding Builder::build() {
  const std::int64_t blocks = (left_ + kRoomsInBlock - 1) / kRoomsInBlock;
  const auto columns = static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(blocks))));
  const Pose2 turned{0.0, 0.0, radians(kBuildingTurn_deg)};
  for (std::int64_t b = 0; b < blocks; ++b) {
    add_block(turned * Pose2{static_cast<double>(b % columns) * kPitch_m,
                             static_cast<double>(b / columns) * kPitch_m, 0.0});
  }
  return std::move(building_);
}

}  // namespace

std::vector<Polygon> NoisyBuilding::free_space() const {
  std::vector<Polygon> polygons;
  polygons.reserve(outlines.size() + openings.size());
  for (const PlacedOutline& outline : outlines) polygons.push_back(outline.outline);
  polygons.insert(polygons.end(), openings.begin(), openings.end());
  return polygons;
}

NoisyBuilding noisy_building(std::int64_t rooms, std::uint64_t seed) {
  return Builder(rooms, seed).build();
}

}  // namespace roomatlas::bench
