// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "draw/plan_fixture.hpp"

namespace roomatlas::test {

inline Ring rectangle(const Point2& low, const Point2& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

inline PlanDoor opening(std::int64_t id, DoorKind kind, const Ring& ring, const Segment2& jambs) {
  PlanDoor door;
  door.id = id;
  door.kind = kind;
  door.opening = ring;
  door.jambs = jambs;
  door.width_m = (jambs.b - jambs.a).norm();
  return door;
}

/// A flat with all that a drafted plan may show; walls of 0.3, 0.24 and 0.1 m:
///     +-- unexplored ---+
///     |       3         |
///     |--d1-----passage-|      d1: its leaf was seen, in room 3
///     :   1   ; 2       |      : and ; inferred, the latter seen from room 1
///     +-window-+--------d2     d2: no leaf
inline FloorPlan flat() {
  FloorPlan plan;
  plan.title = "Flat";
  plan.rooms = {room(1, "1", RoomKind::room, {{0.3, 0.3}, {3.873, 3.3}}),
                room(2, "Kitchen", RoomKind::room, {{3.973, 0.3}, {6.514, 3.3}}),
                room(3, "Living room", RoomKind::hall, {{0.3, 3.54}, {6.514, 6.0}})};
  Polygon walls{rectangle({0, 0}, {6.814, 6.3}), {}};
  for (const PlanRoom& inside : plan.rooms) walls.holes.push_back(inside.parts.front().outer);
  plan.walls = {walls};
  plan.doors = {
      opening(1, DoorKind::door, rectangle({1, 3.3}, {1.9, 3.54}), {{1, 3.42}, {1.9, 3.42}}),
      opening(2, DoorKind::door, rectangle({6.514, 1}, {6.814, 1.9}), {{6.664, 1}, {6.664, 1.9}}),
      opening(3, DoorKind::passage, rectangle({4.5, 3.3}, {5.9, 3.54}), {{4.5, 3.42}, {5.9, 3.42}}),
      opening(4, DoorKind::window, rectangle({1, 0}, {2.2, 0.3}), {{1, 0.15}, {2.2, 0.15}})};
  plan.doors[0].room_a = 1;
  plan.doors[0].room_b = 3;
  plan.doors[0].leaf = Segment2{{1, 3.42}, {1.15, 4.3}};
  plan.furniture = {{{rectangle({0.3, 0.4}, {0.8, 1.6}), {}}, FurnitureKind::against_wall},
                    {{rectangle({3.0, 4.4}, {4.4, 5.2}), {}}, FurnitureKind::free_standing}};
  for (const PlanRoom& inside : plan.rooms) {
    const Ring& ring = inside.parts.front().outer;
    for (std::size_t i = 0; i < 4; ++i) {
      plan.edges.push_back({inside.id, {ring[i], ring[(i + 1) % 4]}, WallEvidence::measured, 0.02});
    }
  }
  for (const std::size_t inferred : {3U, 7U}) {  // on the left of rooms 1 and 2
    plan.edges[inferred].evidence = WallEvidence::inferred;
    plan.edges[inferred].deviation_m.reset();
  }
  plan.edges[10].evidence = WallEvidence::unexplored;
  return plan;
}

/// The plan in a frame of its own.
inline FloorPlan moved(FloorPlan plan, const Pose2& to) {
  for (PlanRoom& one : plan.rooms) {
    for (Polygon& part : one.parts) part = transformed(to, part);
    one.label_point = to * one.label_point;
  }
  for (PlanDoor& door : plan.doors) {
    door.jambs = transformed(to, door.jambs);
    door.opening = transformed(to, Polyline(door.opening));
    if (door.leaf) door.leaf = transformed(to, *door.leaf);
  }
  for (Polygon& wall : plan.walls) wall = transformed(to, wall);
  for (PlanFurniture& piece : plan.furniture) piece.outline = transformed(to, piece.outline);
  for (PlanEdge& edge : plan.edges) edge.line = transformed(to, edge.line);
  return plan;
}

}  // namespace roomatlas::test
