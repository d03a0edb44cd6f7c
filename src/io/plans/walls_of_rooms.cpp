// SPDX-License-Identifier: GPL-3.0-or-later
#include "walls_of_rooms.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr double kHalfWall_m = 0.02;   // thin: rooms are as large as they are drawn
constexpr double kReach_m = 0.6;       // of a door to the edges of its rooms: a thick wall
constexpr double kLeastDepth_m = 0.1;  // of a doorway between rooms that touch

std::vector<Segment2> edges_of(const PlanRoom& room) {
  std::vector<Segment2> edges;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
  };
  for (const Polygon& part : room.parts) {
    add(part.outer);
    for (const Ring& hole : part.holes) add(hole);
  }
  return edges;
}

Point2 direction_of(const Segment2& edge) {
  const Point2 along = edge.b - edge.a;
  const double length_m = along.norm();
  return length_m > 0.0 ? Point2(along / length_m) : Point2(1.0, 0.0);
}

Point2 nearest_on(const Segment2& edge, const Point2& point) {
  const double length_m = (edge.b - edge.a).norm();
  const Point2 along = direction_of(edge);
  return edge.a + std::clamp((point - edge.a).dot(along), 0.0, length_m) * along;
}

/// The edge of a room that is nearest to a door.
struct NearEdge {
  RoomId room = 0;
  Segment2 edge;
  Point2 at = Point2::Zero();
  double distance_m = 0.0;
};

/// Of each room, the nearest first.
std::vector<NearEdge> edges_near(const std::vector<PlanRoom>& rooms, const Point2& door) {
  std::vector<NearEdge> near;
  for (const PlanRoom& room : rooms) {
    NearEdge best{room.id, {}, {}, 2.0 * kReach_m};
    for (const Segment2& edge : edges_of(room)) {
      const Point2 at = nearest_on(edge, door);
      const double distance_m = (at - door).norm();
      if (distance_m < best.distance_m) best = {room.id, edge, at, distance_m};
    }
    if (best.distance_m <= kReach_m) near.push_back(best);
  }
  std::stable_sort(near.begin(), near.end(), [](const NearEdge& a, const NearEdge& b) {
    return a.distance_m < b.distance_m;
  });
  return near;
}

/// A stretch of wall.
Polygon slab(const Point2& from, const Point2& to) {
  const Point2 along = kHalfWall_m * direction_of({from, to});
  const Point2 left(-along.y(), along.x());
  return {{from - along - left, to + along - left, to + along + left, from - along + left}, {}};
}

/// What doors leave of an edge, as spans in metres from its beginning.
using Spans = std::vector<std::pair<double, double>>;

Spans cut(const Spans& spans, double from, double to) {
  Spans left;
  for (const auto& [begin, end] : spans) {
    if (begin < std::min(end, from)) left.emplace_back(begin, std::min(end, from));
    if (std::max(begin, to) < end) left.emplace_back(std::max(begin, to), end);
  }
  return left;
}

/// True where an edge lies along a doorway, in either room's wall.
bool is_along(const Segment2& edge, const PlanDoor& door) {
  constexpr double kSlant = 0.2;  // sine of what still counts as parallel
  const Point2 along = direction_of(edge);
  const Point2 line = direction_of(door.jambs);
  const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
  const Point2 off = middle - edge.a;
  const bool is_parallel = std::abs(along.x() * line.y() - along.y() * line.x()) < kSlant;
  return is_parallel && std::abs(along.x() * off.y() - along.y() * off.x()) <= kReach_m;
}

Spans open_spans(const Segment2& edge, RoomId room, const std::vector<PlanDoor>& doors) {
  Spans spans = {{0.0, (edge.b - edge.a).norm()}};
  const Point2 along = direction_of(edge);
  for (const PlanDoor& door : doors) {
    if (door.room_a != room && door.room_b != room) continue;
    if (!is_along(edge, door)) continue;
    const double a = (door.jambs.a - edge.a).dot(along);
    const double b = (door.jambs.b - edge.a).dot(along);
    spans = cut(spans, std::min(a, b), std::max(a, b));
  }
  return spans;
}

}  // namespace

std::optional<PlanDoor> door_of_rooms(const std::vector<PlanRoom>& rooms, const ShownDoor& shown,
                                      DoorId id) {
  const std::vector<NearEdge> near = edges_near(rooms, shown.at);
  if (near.empty()) return std::nullopt;
  const NearEdge& here = near[0];
  const NearEdge& there = near.size() > 1 ? near[1] : near[0];
  const Point2 half = shown.width_m / 2.0 * direction_of(here.edge);
  const Point2 middle = (here.at + there.at) / 2.0;
  PlanDoor door;
  door.id = id;
  door.width_m = shown.width_m;
  door.jambs = {middle - half, middle + half};
  door.room_a = here.room;
  if (near.size() > 1) door.room_b = there.room;
  if (door.room_b && *door.room_b < *door.room_a) std::swap(door.room_a, door.room_b);
  const Point2 normal = Point2(-half.y(), half.x()) / half.norm();
  const double depth_m = std::max(kLeastDepth_m, std::abs((there.at - here.at).dot(normal)));
  const Point2 deep = depth_m / 2.0 * normal;
  door.opening = {door.jambs.a - deep, door.jambs.b - deep, door.jambs.b + deep,
                  door.jambs.a + deep};
  return door;
}

std::vector<Polygon> walls_of_rooms(const FloorPlan& plan) {
  std::vector<Polygon> walls;
  for (const PlanRoom& room : plan.rooms) {
    for (const Segment2& edge : edges_of(room)) {
      const Point2 along = direction_of(edge);
      for (const auto& [from, to] : open_spans(edge, room.id, plan.doors)) {
        walls.push_back(slab(edge.a + from * along, edge.a + to * along));
      }
    }
  }
  for (const PlanDoor& door : plan.doors) {  // else one would look and drive into the walls
    const double depth_m = (door.opening[3] - door.opening[0]).norm();
    if (depth_m <= kLeastDepth_m) continue;
    walls.push_back(slab(door.opening[0], door.opening[3]));
    walls.push_back(slab(door.opening[1], door.opening[2]));
  }
  return walls;
}

}  // namespace roomatlas::io
