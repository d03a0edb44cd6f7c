// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/draw/draw.hpp"

#include <initializer_list>
#include <string>
#include <utility>

namespace roomatlas::test {

inline PlanRoom room(RoomId id, const std::string& name, RoomKind kind, const Box2& box) {
  const auto [x0, y0] = std::pair(box.min.x(), box.min.y());
  const auto [x1, y1] = std::pair(box.max.x(), box.max.y());
  PlanRoom room;
  room.id = id;
  room.name = name;
  room.kind = kind;
  room.parts = {{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}}};
  room.area_m2 = (x1 - x0) * (y1 - y0);
  room.label_point = {(x0 + x1) / 2.0, (y0 + y1) / 2.0};
  return room;
}

/// Three rooms above a corridor; a closet and a cupboard to the right of it:
///     +--------+--+-----------------+
///     |  Lab   |2 |  Long name      |
///     +--    --+--+----    ---------+--+-+
///     |         corridor            |  |c|
///     +-----------------------------+--+-+
inline FloorPlan office() {
  FloorPlan plan;
  plan.title = "Office";
  plan.rooms = {room(1, "Lab <A&B>", RoomKind::room, {{0, 2.2}, {6, 7}}),
                room(2, "2", RoomKind::room, {{6.2, 2.2}, {7.4, 7}}),
                room(3, "Conference room Ada Lovelace", RoomKind::hall, {{7.6, 2.2}, {18, 11}}),
                room(4, "4", RoomKind::corridor, {{0, 0}, {18, 2}}),
                room(5, "Closet", RoomKind::room, {{18.2, 0}, {19.2, 2}}),
                room(6, "Cupboard", RoomKind::room, {{19.4, 0}, {19.7, 2}})};
  plan.walls = {{{{-0.2, 2}, {18.2, 2}, {18.2, 2.2}, {-0.2, 2.2}}, {}}};
  PlanDoor door;
  door.id = 1;
  door.jambs = {{2, 2.1}, {2.9, 2.1}};
  door.width_m = 0.9;
  door.opening = {{2, 2}, {2.9, 2}, {2.9, 2.2}, {2, 2.2}};
  door.room_a = 1;
  door.room_b = 4;
  plan.doors = {door};
  return plan;
}

inline PlanAnnotations annotations() {
  PlanAnnotations notes;
  notes.mission = "office.clf.gz";
  notes.date = "2003-02-19";
  notes.path_length_m = 391.4;
  notes.trajectory = {{1, 1}, {2.4, 1}, {2.4, 4}};
  notes.room_graph = {{1, 4}, {4, 99}};
  return notes;
}

}  // namespace roomatlas::test
