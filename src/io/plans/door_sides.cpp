// SPDX-License-Identifier: GPL-3.0-or-later
#include "door_sides.hpp"

#include <algorithm>
#include <cmath>

#include "geojson_geometry.hpp"
#include "roomatlas/planar/union.hpp"

namespace roomatlas::io {
namespace {

Point2 across(const PlanDoor& door) {
  const Point2 along = (door.jambs.b - door.jambs.a).normalized();
  return {-along.y(), along.x()};
}

/// The corners of the hole beyond the door line, between its jambs.
Ring half_of(const PlanDoor& door, double side) {
  constexpr double kOnLine_m = 0.0015;  // nearer corners lie on the door line
  const Point2 along = door.jambs.b - door.jambs.a;
  const Point2 way = side * across(door);
  Ring corners;
  for (const Point2& corner : door.opening) {
    if ((corner - door.jambs.a).dot(way) > kOnLine_m) corners.push_back(to_millimetre(corner));
  }
  if (corners.size() < 2) return {};
  std::sort(corners.begin(), corners.end(),
            [&](const Point2& p, const Point2& q) { return p.dot(along) > q.dot(along); });
  Ring ring = {to_millimetre(door.jambs.a), to_millimetre(door.jambs.b)};
  ring.insert(ring.end(), corners.begin(), corners.end());
  return ring;
}

/// +1 where the room lies left of the way from jamb a to b, -1 right of it, 0 where neither is
/// seen.
int side_of(const PlanRoom& room, const PlanDoor& door) {
  double depth_m = 0.0;
  for (const Point2& corner : door.opening) {
    depth_m = std::max(depth_m, std::abs((corner - door.jambs.a).dot(across(door))));
  }
  const auto is_in = [&](const Point2& point) {
    return std::any_of(room.parts.begin(), room.parts.end(),
                       [&](const Polygon& part) { return contains(part, point); });
  };
  const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
  for (const double beyond_m : {0.02, 0.1, 0.3, 0.6}) {
    const Point2 way = (depth_m + beyond_m) * across(door);
    const bool is_left = is_in(middle + way);
    const bool is_right = is_in(middle - way);
    if (is_left != is_right) return is_left ? 1 : -1;
  }
  return 0;
}

}  // namespace

DoorSides sides_of(const PlanDoor& door, const FloorPlan& plan) {
  DoorSides sides{half_of(door, 1.0), half_of(door, -1.0), std::nullopt, std::nullopt};
  const auto place = [&](const PlanRoom& room) {
    const int side = side_of(room, door);
    if (side > 0) sides.left_room = room.id;
    if (side < 0) sides.right_room = room.id;
  };
  if (!door.room_a && !door.room_b) {  // nobody said: whose floor is next to it
    for (const PlanRoom& room : plan.rooms) place(room);
  }
  for (const std::optional<RoomId>& id : {door.room_a, door.room_b}) {
    if (const PlanRoom* room = id ? find_room(plan, *id) : nullptr) place(*room);
  }
  return sides;
}

std::vector<Polygon> up_to_doors(const PlanRoom& room, const FloorPlan& plan,
                                 const std::vector<DoorSides>& doors) {
  std::vector<Polygon> parts = room.parts;
  for (std::size_t i = 0; i < doors.size(); ++i) {
    if (plan.doors[i].kind == DoorKind::window) continue;
    const DoorSides& sides = doors[i];
    if (sides.left_room == room.id && !sides.left.empty()) parts.push_back({sides.left, {}});
    if (sides.right_room == room.id && !sides.right.empty()) parts.push_back({sides.right, {}});
  }
  return parts.size() == room.parts.size() ? parts : union_of(parts);
}

std::vector<Polygon> without_holes_of_doors(const Polygon& wall, const FloorPlan& plan) {
  std::vector<Polygon> holes;
  for (const PlanDoor& door : plan.doors) {
    if (door.opening.size() > 2) holes.push_back({door.opening, {}});
  }
  constexpr double kNothing_m2 = 1e-3;
  if (holes.empty() || overlap_area({wall}, holes) < kNothing_m2) return {wall};
  return difference_of({wall}, holes);
}

std::vector<Polygon> covered_by(const FloorPlan& plan) {
  std::vector<Polygon> shapes = plan.walls;
  for (const PlanRoom& room : plan.rooms) {
    shapes.insert(shapes.end(), room.parts.begin(), room.parts.end());
  }
  for (const PlanDoor& door : plan.doors) {
    if (door.opening.size() > 2) shapes.push_back({door.opening, {}});
  }
  std::vector<Polygon> covered = union_of(shapes);
  for (Polygon& part : covered) part.holes.clear();
  return union_of(covered);
}

}  // namespace roomatlas::io
