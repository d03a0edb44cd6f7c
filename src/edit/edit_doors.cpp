// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>

#include "editable.hpp"
#include "roomatlas/planar/union.hpp"

namespace roomatlas::edit {
namespace {

constexpr double kStep_m = 0.05;
constexpr double kWidestDoor_m = 4.0;
constexpr double kMostShared_m = 0.1;  // of two doors beside each other: maps differ by less
constexpr double kThinWall_m = 0.10;   // drawn where rooms went over into each other
constexpr double kOpenShare = 0.2;     // of such a wall that is floor: no wall is there yet

std::string place(const Point2& at) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.2f, %.2f)", at.x(), at.y());
  return text;
}

/// The nearest within reach; the end where there is none.
std::vector<Door>::iterator door_near(MappedBuilding& building, const Point2& at) {
  auto nearest = building.doors.end();
  double least_m = kEditReach_m;
  for (auto door = building.doors.begin(); door != building.doors.end(); ++door) {
    const double apart_m = distance(door->jambs, at);
    if (apart_m > least_m || (apart_m == least_m && nearest != building.doors.end())) continue;
    least_m = apart_m;
    nearest = door;
  }
  return nearest;
}

/// The first that would lie over one between these jambs.
std::vector<Door>::const_iterator door_in(const MappedBuilding& building, const Segment2& jambs) {
  return std::find_if(building.doors.begin(), building.doors.end(), [&](const Door& other) {
    const Polygon over = band(jambs, kThickestWall_m / 2.0, kThickestWall_m / 2.0,
                              other.width_m / 2.0 - kMostShared_m);
    return contains(over, other.frame_from_pivot.position());
  });
}

Why no_door(const Point2& at) { return "no door or opening is near " + place(at); }

/// The first room on the way from the middle of a door to one of its sides.
std::optional<RoomId> room_beside(const MappedBuilding& building, const Point2& from,
                                  const Point2& way) {
  for (double at_m = kStep_m; at_m <= kThickestWall_m; at_m += kStep_m) {
    const Point2 point = from + at_m * way;
    for (const PlacedOutline& outline : building.outlines) {
      if (contains(outline.outline, point)) return outline.room;
    }
  }
  return std::nullopt;
}

}  // namespace

Why shut_door(const Edit& edit, MappedBuilding& building) {
  const auto found = door_near(building, edit.at);
  if (found == building.doors.end()) return no_door(edit.at);
  const Door door = *found;
  building.doors.erase(found);
  const Polygon wall = band(door.jambs, kThinWall_m / 2.0, kThinWall_m / 2.0, 0.0);
  building.wall_bodies.push_back(wall);
  for (const auto& side : {door.room_a, door.room_b}) {
    if (!side) continue;
    const Shapes room = shapes_of(building.outlines, *side);
    if (overlap_area(room, {wall}) < kOpenShare * area({wall})) continue;
    set_shapes(building, *side, difference_of(room, {wall}));
  }
  return {};
}

Why open_door(const Edit& edit, MappedBuilding& building) {
  const auto door = door_near(building, edit.at);
  if (door == building.doors.end()) return no_door(edit.at);
  if (door->kind != DoorKind::window) return "what is there is open already";
  door->kind = DoorKind::door;
  return {};
}

Why add_door(const Edit& edit, MappedBuilding& building) {
  const Point2 middle = (edit.line.a + edit.line.b) / 2.0;
  const double width_m = (edit.line.b - edit.line.a).norm();
  if (width_m > kWidestDoor_m) return "a door is at most 4 m wide";
  if (const auto other = door_in(building, edit.line); other != building.doors.end()) {
    return std::string(other->kind == DoorKind::window ? "a window" : "a door") +
           " is there already, near " + place(other->frame_from_pivot.position());
  }
  const Door door = door_between(edit.line, std::nullopt, std::nullopt);
  const Point2 ahead = door.frame_from_pivot * Point2(1.0, 0.0) - middle;
  Door added = door;
  added.room_a = room_beside(building, middle, -ahead);
  added.room_b = room_beside(building, middle, ahead);
  if (!added.room_a || !added.room_b) {
    return "a room lies on " + std::string(added.room_a || added.room_b ? "one side" : "no side") +
           " of " + place(middle) + " alone, and a door joins two";
  }
  if (added.room_a == added.room_b) {
    return "one room lies on both sides of " + place(middle) + ", and a door joins two";
  }
  building.doors.push_back(added);
  return {};
}

}  // namespace roomatlas::edit
