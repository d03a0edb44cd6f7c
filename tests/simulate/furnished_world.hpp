// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "roomatlas/simulate/world.hpp"
#include "simulate/simulated.hpp"

namespace roomatlas::testing_simulate {

inline PlanRoom room_of(RoomId id, RoomKind kind, const Ring& outline) {
  PlanRoom room;
  room.id = id;
  room.kind = kind;
  room.parts = {{outline, {}}};
  room.area_m2 = area(room.parts.front());
  room.label_point = interior_point(room.parts.front());
  return room;
}

inline PlanDoor door_of(std::int64_t id, RoomId a, RoomId b, const Ring& opening,
                        const Segment2& jambs) {
  PlanDoor door;
  door.id = id;
  door.jambs = jambs;
  door.width_m = (jambs.b - jambs.a).norm();
  door.opening = opening;
  door.room_a = a;
  door.room_b = b;
  return door;
}

/// Two offices of 5 m x 6 m (1, 2) beside each other, a narrow corridor (3) of 1.3 m above, and a
/// hall (4) of 11 m x 7 m on top of it. Doors of 0.9 m: 1-2, 1-3, 2-3, 3-4.
inline FloorPlan offices() {
  FloorPlan world;
  world.rooms = {room_of(1, RoomKind::room, box(0, 0, 5, 6)),
                 room_of(2, RoomKind::room, box(5.2, 0, 10.2, 6)),
                 room_of(3, RoomKind::corridor, box(0, 6.2, 10.2, 7.5)),
                 room_of(4, RoomKind::hall, box(0, 7.7, 10.2, 15))};
  world.doors = {
      door_of(1, 1, 2, box(5, 0.7, 5.2, 1.6), {{5.1, 0.7}, {5.1, 1.6}}),
      door_of(2, 1, 3, box(2, 6, 2.9, 6.2), {{2, 6.1}, {2.9, 6.1}}),
      door_of(3, 2, 3, box(7, 6, 7.9, 6.2), {{7, 6.1}, {7.9, 6.1}}),
      door_of(4, 3, 4, box(4.6, 7.5, 5.5, 7.7), {{4.6, 7.6}, {5.5, 7.6}}),
  };
  for (const Ring& wall : {box(-0.2, -0.2, 10.4, 0), box(-0.2, 0, 0, 15), box(10.2, 0, 10.4, 15),
                           box(-0.2, 15, 10.4, 15.2), box(5, 0, 5.2, 0.7), box(5, 1.6, 5.2, 6),
                           box(0, 6, 2, 6.2), box(2.9, 6, 7, 6.2), box(7.9, 6, 10.2, 6.2),
                           box(0, 7.5, 4.6, 7.7), box(5.5, 7.5, 10.2, 7.7)}) {
    world.walls.push_back({wall, {}});
  }
  return world;
}

inline bool is_in_any(const std::vector<Polygon>& polygons, const Point2& at) {
  return std::any_of(polygons.begin(), polygons.end(),
                     [&](const Polygon& polygon) { return contains(polygon, at); });
}

inline double distance_to(const Polygon& polygon, const Point2& at) {
  double least_m = distance_to_boundary(polygon.outer, at);
  for (const Ring& hole : polygon.holes) {
    least_m = std::min(least_m, distance_to_boundary(hole, at));
  }
  return least_m;
}

/// From the nearest of some bodies; 0 inside of one, 0.6 where none is that near.
inline double clearance_m(const std::vector<Polygon>& bodies, const Point2& at) {
  constexpr double kFarM = 0.6;
  double least_m = kFarM;
  for (const Polygon& body : bodies) {
    const Box2 box = bounds(body.outer);
    if ((at.array() < box.min.array() - kFarM).any()) continue;
    if ((at.array() > box.max.array() + kFarM).any()) continue;
    least_m = contains(body, at) ? 0.0 : std::min(least_m, distance_to(body, at));
  }
  return least_m;
}

inline std::vector<Polygon> all_bodies(const FloorPlan& world) {
  std::vector<Polygon> bodies = world.walls;
  for (const auto& more : {outlines_of(world.furniture), open_leaves(world)}) {
    bodies.insert(bodies.end(), more.begin(), more.end());
  }
  return bodies;
}

using Cells = std::set<std::pair<int, int>>;
constexpr double kFloodM = 0.05;

inline Point2 place_of(const std::pair<int, int>& cell) {
  return kFloodM * Point2(cell.first + 0.37, cell.second + 0.37);  // another raster than the tool's
}

inline std::pair<int, int> cell_at(const Point2& at) {
  return {static_cast<int>(std::lround(at.x() / kFloodM - 0.37)),
          static_cast<int>(std::lround(at.y() / kFloodM - 0.37))};
}

/// The cells of a grid that are reached from a place over cells that are open: a plain flood fill.
template <typename IsOpen>
Cells reached(const Point2& start, IsOpen is_open) {
  Cells seen;
  Cells asked;
  std::vector<std::pair<int, int>> open = {cell_at(start)};
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    if (!asked.insert({x, y}).second || !is_open(place_of({x, y}))) continue;
    seen.insert({x, y});
    for (const auto& [dx, dy] :
         {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
      open.push_back({x + dx, y + dy});
    }
  }
  return seen;
}

inline Point2 middle_of(const PlanDoor& door) { return (door.jambs.a + door.jambs.b) / 2.0; }

}  // namespace roomatlas::testing_simulate
