// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/explore.hpp"

#include "explorer.hpp"
#include "robot.hpp"
#include "roomatlas/simulate/world.hpp"

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

bool turns_freely(const FloorPlan& world, const Point2& at, const RobotFootprint& footprint) {
  try {
    require_free(world, at, std::hypot(footprint.length_m, footprint.width_m) / 2.0);
    return true;
  } catch (const InputError&) {
    return false;
  }
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
  throw InputError("world: found no place where the robot can turn; say one with --start");
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
