// SPDX-License-Identifier: GPL-3.0-or-later
#include "number_text.hpp"
#include "roomatlas/simulate/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

struct NearestObstacle {
  std::string name;
  double distance_m = std::numeric_limits<double>::infinity();  ///< 0 inside it
  Point2 at = Point2::Zero();                                   ///< its nearest point
};

Point2 nearest_on(const Segment2& edge, const Point2& point) {
  const Point2 along = edge.b - edge.a;
  const double length_squared = along.squaredNorm();
  if (length_squared == 0.0) return edge.a;
  return edge.a + std::clamp((point - edge.a).dot(along) / length_squared, 0.0, 1.0) * along;
}

void update(const Ring& ring, const Point2& point, const std::string& name, NearestObstacle& best) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 at = nearest_on({ring[i], ring[(i + 1) % ring.size()]}, point);
    const double distance_m = (at - point).norm();
    if (distance_m < best.distance_m) best = {name, distance_m, at};
  }
}

void update(const std::vector<Polygon>& polygons, const Point2& point, const std::string& kind,
            NearestObstacle& best) {
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const std::string name = kind + " " + std::to_string(i + 1);
    if (contains(polygons[i], point)) best = {name, 0.0, point};
    update(polygons[i].outer, point, name, best);
    for (const Ring& hole : polygons[i].holes) update(hole, point, name, best);
  }
}

NearestObstacle nearest_obstacle(const FloorPlan& world, const Point2& point) {
  NearestObstacle best;
  update(world.walls, point, "wall", best);
  update(outlines_of(world.furniture), point, "piece of furniture", best);
  update(open_leaves(world), point, "open door leaf", best);
  return best;
}

bool is_in_a_room_or_door(const FloorPlan& world, const Point2& point) {
  return std::any_of(world.rooms.begin(), world.rooms.end(),
                     [&](const PlanRoom& room) {
                       return std::any_of(
                           room.parts.begin(), room.parts.end(),
                           [&](const Polygon& part) { return contains(part, point); });
                     }) ||
         std::any_of(world.doors.begin(), world.doors.end(),
                     [&](const PlanDoor& door) { return contains(door.opening, point); });
}

/// Names the nearest room whose middle is free, where there is one.
std::string remedy(const FloorPlan& world, const Point2& point, double clearance_m) {
  const PlanRoom* best = nullptr;
  for (const PlanRoom& room : world.rooms) {
    if (nearest_obstacle(world, room.label_point).distance_m < clearance_m) continue;
    if (best == nullptr || (room.label_point - point).norm() < (best->label_point - point).norm()) {
      best = &room;
    }
  }
  if (best == nullptr) return "choose a place with more room around it";
  return "choose a free place, such as " + place_text(best->label_point) + " in room " +
         std::to_string(best->id);
}

}  // namespace

double clearance_m(const FloorPlan& world, const Point2& point) {
  return nearest_obstacle(world, point).distance_m;
}

void require_free(const FloorPlan& world, const Point2& point, double clearance_m) {
  const std::string start = "the robot's place " + place_text(point) + " ";
  if (!point.allFinite()) throw InputError(start + "is not a place: expected two finite numbers");
  const NearestObstacle nearest = nearest_obstacle(world, point);
  const auto fail = [&](const std::string& what) {
    throw InputError(start + what + ": " + remedy(world, point, clearance_m));
  };
  if (nearest.distance_m == 0.0) fail("is in " + nearest.name);
  if (nearest.distance_m < clearance_m) {
    fail("is " + number_text(nearest.distance_m) + " m from " + nearest.name + " at " +
         place_text(nearest.at) + ", and the robot needs " + number_text(clearance_m) + " m");
  }
  if (!world.rooms.empty() && !is_in_a_room_or_door(world, point)) {
    fail("is outside of all rooms, " + number_text(nearest.distance_m) + " m from " + nearest.name);
  }
}

}  // namespace roomatlas
