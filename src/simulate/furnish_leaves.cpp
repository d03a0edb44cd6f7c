// SPDX-License-Identifier: GPL-3.0-or-later
#include "furnish_leaves.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "random_stream.hpp"
#include "roomatlas/simulate/world.hpp"

namespace roomatlas {
namespace {

constexpr double kLeastWidthM = 0.7;  // a door that the robot passes beside its leaf
constexpr double kMostWidthM = 1.3;   // wider openings have no leaf, or two
constexpr double kLeastAngleDeg = 60.0;
constexpr double kMostAngleDeg = 120.0;
constexpr double kJambInsetM = 0.025;  // of the hinge: half the leaf's thickness and a little
constexpr double kFaceInsetM = 0.03;   // of the hinge from the wall's face, to swing beyond 90 deg
constexpr double kShorterM = 0.04;     // than the door is wide
constexpr double kBesideJambM = 0.05;  // where the wall's face is looked for
constexpr double kThickestWallM = 0.6;
constexpr double kFaceStepM = 0.01;
constexpr double kHalfWayM = 0.38;  // from the leaf to the middle of the way past it, where a robot
                                    // that turns needs 0.30: less makes doors that few get through
constexpr int kTriesOfLeaf = 8;     // side, jamb and angle

bool is_in(const std::vector<Polygon>& polygons, const Point2& point) {
  return std::any_of(polygons.begin(), polygons.end(),
                     [&](const Polygon& polygon) { return contains(polygon, point); });
}

/// How far from the door line the wall beside a jamb ends, on the side of `normal`.
std::optional<double> face_m(const std::vector<Polygon>& walls, const Point2& beside_jamb,
                             const Point2& normal) {
  for (double away_m = 0.0; away_m <= kThickestWallM; away_m += kFaceStepM) {
    if (!is_in(walls, beside_jamb + away_m * normal)) return away_m;
  }
  return std::nullopt;
}

/// The walls near to a door, so that not all of the building's are asked again and again.
std::vector<Polygon> walls_near(const FloorPlan& world, const Point2& point) {
  std::vector<Polygon> near;
  for (const Polygon& wall : world.walls) {
    const Box2 box = bounds(wall.outer);
    if ((point.array() >= box.min.array() - 2.0).all() &&
        (point.array() <= box.max.array() + 2.0).all()) {
      near.push_back(wall);
    }
  }
  return near;
}

/// A leaf as it might stand, by chance.
std::optional<Segment2> some_leaf(const PlanDoor& door, const std::vector<Polygon>& walls,
                                  RandomStream& random) {
  const bool swap = random.uniform() < 0.5;
  const bool left = random.uniform() < 0.5;
  const double angle_rad =
      radians(kLeastAngleDeg + (kMostAngleDeg - kLeastAngleDeg) * random.uniform());
  const Point2& jamb = swap ? door.jambs.b : door.jambs.a;
  const Point2& other = swap ? door.jambs.a : door.jambs.b;
  const double width_m = (other - jamb).norm();
  const Point2 closed = (other - jamb) / width_m;
  const Point2 normal = (left ? 1.0 : -1.0) * Point2(-closed.y(), closed.x());
  const auto away_m = face_m(walls, jamb - kBesideJambM * closed, normal);
  if (!away_m) return std::nullopt;
  const Point2 hinge = jamb + kJambInsetM * closed + (*away_m + kFaceInsetM) * normal;
  const Point2 along = std::cos(angle_rad) * closed + std::sin(angle_rad) * normal;
  return Segment2{hinge, hinge + (width_m - kShorterM) * along};
}

const PlanRoom* room_at(const FloorPlan& world, const PlanDoor& door, const Point2& point) {
  for (const PlanRoom& room : world.rooms) {
    if ((door.room_a == room.id || door.room_b == room.id) && is_in(room.parts, point)) {
      return &room;
    }
  }
  return nullptr;
}

}  // namespace

void open_some_doors(FloorPlan& world, std::uint64_t seed, double share, FurnishSite& site,
                     std::map<RoomId, RoomWays>& ways) {
  for (PlanDoor& door : world.doors) {
    RandomStream random(seed, "leaf of door " + std::to_string(door.id));
    if (random.uniform() >= share || door.kind != DoorKind::door || door.leaf) continue;
    const double width_m = (door.jambs.b - door.jambs.a).norm();
    if (!(width_m >= kLeastWidthM && width_m <= kMostWidthM)) continue;
    const auto walls = walls_near(world, (door.jambs.a + door.jambs.b) / 2.0);
    for (int i = 0; i < kTriesOfLeaf && !door.leaf; ++i) {
      const auto leaf = some_leaf(door, walls, random);
      if (!leaf) continue;
      const PlanRoom* room = room_at(world, door, (leaf->a + leaf->b) / 2.0);
      const Ring outline = leaf_outline(*leaf);
      if (room == nullptr || !site.has_place_for_leaf(outline)) continue;
      if (!ways.at(room->id).add(outline, kHalfWayM)) continue;
      site.add(outline);
      door.leaf = leaf;
    }
  }
}

}  // namespace roomatlas
