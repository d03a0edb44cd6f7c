// SPDX-License-Identifier: GPL-3.0-or-later
#include "changes/driven_mission.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "roomatlas/correct/correct.hpp"
#include "roomatlas/pipeline/map_mission.hpp"
#include "support/memory_mission.hpp"

namespace roomatlas::bench {
namespace {

RoomId room_at(const FloorPlan& world, const Point2& at) {
  for (const PlanRoom& room : world.rooms) {
    for (const Polygon& part : room.parts) {
      if (contains(part, at)) return room.id;
    }
  }
  return 0;
}

/// The building's frame, of all poses: headings by their mean, then places.
/// @param[out] off_m the farthest pose from its true place
Pose2 world_from_building(const AsrSource& source, const Placement& placement,
                          const std::map<double, Pose2>& truth, double& off_m) {
  std::vector<std::pair<Pose2, Pose2>> pairs;  // world, building
  Point2 turn = Point2::Zero();
  for (const AsrId id : source.ids()) {
    for (const PathSample& sample : source.get(id, AsrDetail::path).path) {
      const auto true_pose = truth.find(sample.timestamp_s);
      if (true_pose == truth.end()) continue;
      const Pose2 building = placement.at(id) * sample.asr_from_robot;
      pairs.emplace_back(true_pose->second, building);
      turn += direction(true_pose->second.theta_rad - building.theta_rad);
    }
  }
  Pose2 pose{0.0, 0.0, std::atan2(turn.y(), turn.x())};
  Point2 off = Point2::Zero();
  for (const auto& [world, building] : pairs) off += world.position() - pose * building.position();
  off /= static_cast<double>(pairs.size());
  pose = {off.x(), off.y(), pose.theta_rad};
  for (const auto& [world, building] : pairs) {
    off_m = std::max(off_m, (world.position() - pose * building.position()).norm());
  }
  return pose;
}

}  // namespace

AssembledMission DrivenMission::mission() const {
  return {source.get(), placement_of(assembly.correction), assembly.plan, {}};
}

std::unique_ptr<DrivenMission> driven(const FloorPlan& world, const Drive& drive,
                                      const SimulationOptions& robot) {
  auto result = std::make_unique<DrivenMission>();
  std::vector<MissionEvent> events;
  std::map<double, Pose2> truth;
  simulate(world, drive, robot, [&](const SimulatedStep& step) {
    events.emplace_back(step.reading);
    truth[step.reading.timestamp_s] = step.truth.world_from_robot;
    if (const RoomId room = room_at(world, step.truth.world_from_robot.position())) {
      result->entered.insert(room);
    }
  });
  test::MemoryMission mission(std::move(events));
  Options options;
  options.jobs = 1;
  (void)map_mission(mission, result->store, options.map);
  result->assembly = assemble(result->store, {}, options);
  result->source = std::make_unique<WithPaths>(result->store, result->assembly.paths);
  result->world_from_building = world_from_building(
      *result->source, placement_of(result->assembly.correction), truth, result->off_m);
  return result;
}

}  // namespace roomatlas::bench
