// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas::test {

inline Polygon rectangle(double left, double bottom, double right, double top) {
  return {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, {}};
}

inline PlanRoom room(RoomId id, std::vector<Polygon> parts) {
  PlanRoom made;
  made.id = id;
  made.parts = std::move(parts);
  for (const Polygon& part : made.parts) made.area_m2 += area(part);
  return made;
}

inline PlanDoor door(std::int64_t id, const Segment2& jambs, RoomId a, RoomId b) {
  PlanDoor made;
  made.id = id;
  made.jambs = jambs;
  made.width_m = (jambs.b - jambs.a).norm();
  made.room_a = a;
  made.room_b = b;
  return made;
}

/// Walls of 0.2 m. Room 1 has two doors to the corridor.
///   0        4  4.2    7.2  7.4     12.4
///   +-----------------------------------+ 5
///   |                 4                 |
///   +-[1]--[2]--+---[3]---+----[4]------+ 3.2 / 3
///   |     1    [5]   2    |      3      |
///   +-----------+---------+-------------+ 0
inline FloorPlan four_rooms() {
  FloorPlan plan;
  plan.rooms = {room(1, {rectangle(0, 0, 4, 3)}), room(2, {rectangle(4.2, 0, 7.2, 3)}),
                room(3, {rectangle(7.4, 0, 12.4, 3)}), room(4, {rectangle(0, 3.2, 12.4, 5)})};
  plan.doors = {door(1, {{0.5, 3.1}, {1.4, 3.1}}, 1, 4), door(2, {{2.5, 3.1}, {3.4, 3.1}}, 1, 4),
                door(3, {{5, 3.1}, {5.9, 3.1}}, 2, 4), door(4, {{9, 3.1}, {9.9, 3.1}}, 3, 4),
                door(5, {{4.1, 1}, {4.1, 1.9}}, 1, 2)};
  return plan;
}

/// The plan moved: its coordinates in the frame a.
inline FloorPlan moved(const Pose2& a_from_b, FloorPlan plan) {
  for (PlanRoom& r : plan.rooms) {
    for (Polygon& part : r.parts) part = transformed(a_from_b, part);
  }
  for (PlanDoor& d : plan.doors) d.jambs = transformed(a_from_b, d.jambs);
  for (Polygon& wall : plan.walls) wall = transformed(a_from_b, wall);
  return plan;
}

}  // namespace roomatlas::test
