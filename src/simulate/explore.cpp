// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/explore.hpp"

#include "explorer.hpp"
#include "number_text.hpp"
#include "robot.hpp"
#include "roomatlas/simulate/world.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

std::optional<RoomId> room_at(const FloorPlan& world, const Point2& point) {
  for (const PlanRoom& room : world.rooms) {
    for (const Polygon& part : room.parts) {
      if (contains(part, point)) return room.id;
    }
  }
  return std::nullopt;
}

/// Half of the robot's diagonal: what it needs around it to turn.
double turning_radius_m(const RobotFootprint& footprint) {
  return std::hypot(footprint.length_m, footprint.width_m) / 2.0;
}

bool turns_freely(const FloorPlan& world, const Point2& at, const RobotFootprint& footprint) {
  try {
    require_free(world, at, turning_radius_m(footprint));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// The place of a raster over a floor that is farthest from all obstacles, where the robot can turn
/// there: among furniture the middle of a room says nothing.
std::optional<Point2> freest_place(const FloorPlan& world, const Polygon& floor,
                                   const RobotFootprint& footprint) {
  constexpr double kFinest_m = 0.2;
  constexpr double kMostSteps = 100.0;  // of the longer side
  const Box2 box = bounds(floor.outer);
  const double step_m = std::max(kFinest_m, box.size().maxCoeff() / kMostSteps);
  std::optional<Point2> best;
  double best_m = turning_radius_m(footprint);
  for (double x = box.min.x() + step_m / 2.0; x < box.max.x(); x += step_m) {
    for (double y = box.min.y() + step_m / 2.0; y < box.max.y(); y += step_m) {
      const Point2 at(x, y);
      if (!contains(floor, at)) continue;
      const double here_m = clearance_m(world, at);
      if (!(here_m > best_m)) continue;
      best = at;
      best_m = here_m;
    }
  }
  return best;
}

}  // namespace

Pose2 default_start(const FloorPlan& world, const RobotFootprint& footprint) {
  for (const PlanRoom& room : world.rooms) {
    if (turns_freely(world, room.label_point, footprint)) {
      return {room.label_point.x(), room.label_point.y(), 0.0};
    }
  }
  for (const Polygon& free : world.free_space) {
    const Point2 at = interior_point(free);
    if (turns_freely(world, at, footprint)) return {at.x(), at.y(), 0.0};
  }
  std::vector<Polygon> floors;
  for (const PlanRoom& room : world.rooms) {
    floors.insert(floors.end(), room.parts.begin(), room.parts.end());
  }
  floors.insert(floors.end(), world.free_space.begin(), world.free_space.end());
  for (const Polygon& floor : floors) {
    if (const auto at = freest_place(world, floor, footprint)) return {at->x(), at->y(), 0.0};
  }
  if (floors.empty()) {
    throw InputError(
        "world: it has no rooms, so nothing tells inside from outside: say where the robot starts "
        "with --start X,Y,DEG");
  }
  throw InputError("world: found no place where a robot of this size can turn, which takes " +
                   number_text(turning_radius_m(footprint)) +
                   " m around it: give a smaller one with --robot-length and --robot-width, or say "
                   "a place with --start X,Y,DEG");
}

ExploreSummary explore(const FloorPlan& world, const SimulationOptions& simulation,
                       const ExploreOptions& options,
                       const std::function<void(const SimulatedStep&)>& sink) {
  require_sound(simulation);
  const Pose2 world_from_start = options.world_from_start
                                     ? *options.world_from_start
                                     : default_start(world, simulation.footprint);
  require_free(world, world_from_start.position(), simulation.footprint.width_m / 2.0);
  Robot robot(world, simulation, world_from_start);
  Explorer explorer(simulation);
  ExploreSummary summary;
  bool in_contact = false;
  SimulatedStep step = robot.start();
  for (;;) {
    sink(step);
    if (const auto room = room_at(world, step.truth.world_from_robot.position())) {
      summary.entered.insert(*room);
    }
    const Pose2 believed =
        options.on_odometry ? step.odometry.odom_from_robot : step.truth.world_from_robot;
    const std::optional<Steering> steering = explorer.decide(step.reading, believed, in_contact);
    summary.finished = !steering && !explorer.is_stuck();
    if (!steering || summary.duration_s >= options.max_time_s) break;

    std::vector<Motion> motions(2);
    motions[steering->drives_first ? 1 : 0].turn_rad = steering->turn_rad;
    motions[steering->drives_first ? 0 : 1].length_m = steering->length_m;
    const bool contact = robot.would_touch(motions);
    if (contact) motions.clear();
    if (contact && !in_contact) ++summary.collisions;
    in_contact = contact;
    (void)robot.is_pushed();  // it goes on from wherever it is
    step = robot.step(motions);
    summary.duration_s += 1.0 / simulation.rate_hz;
    if (!contact) summary.path_length_m += std::abs(steering->length_m);
  }
  summary.rooms_found = static_cast<std::int64_t>(explorer.rooms().count());
  summary.doorways_found = static_cast<std::int64_t>(explorer.rooms().doors().size());
  summary.goals_given_up = explorer.goals_given_up();
  return summary;
}

}  // namespace roomatlas
