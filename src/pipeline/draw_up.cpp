// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw_up.hpp"

#include <string>
#include <utility>

namespace roomatlas {
namespace {

std::vector<AsrId> asrs_of(RoomId room, const std::map<AsrId, RoomId>& room_of_asr) {
  std::vector<AsrId> asrs;
  for (const auto& [asr, its_room] : room_of_asr) {
    if (its_room == room) asrs.push_back(asr);
  }
  return asrs;
}

}  // namespace

void draw_up(MappedBuilding building, const AssembleOptions& options, Assembly& assembly) {
  const auto plan_of = [&](const auto& outlines, const auto& placed_doors, const auto& bodies) {
    FloorPlan plan = merge(outlines, placed_doors, options.merge, bodies);
    for (PlanRoom& room : plan.rooms) {
      room.asrs = asrs_of(room.id, building.room_of_asr);
      if (const auto name = building.names.find(room.id); name != building.names.end()) {
        room.name = name->second;
      }
      if (const auto kind = building.kinds.find(room.id); kind != building.kinds.end()) {
        room.kind = kind->second;
      }
    }
    plan.furniture = building.furniture;
    return plan;
  };
  const std::vector<Polygon> no_bodies;
  if (building.is_drafted) {
    assembly.plan = plan_of(building.outlines, building.doors, building.wall_bodies);
    std::erase_if(building.edges, [&](const PlanEdge& edge) {
      return !has_room(assembly.plan, edge.room);  // it has no place of its own
    });
    assembly.plan.edges = std::move(building.edges);
    assembly.measured_plan = plan_of(building.measured_outlines, building.doors, no_bodies);
    return;
  }
  assembly.plan = plan_of(building.outlines, building.doors, no_bodies);
  if (!options.regular_walls) return;
  assembly.measured_plan = std::move(assembly.plan);
  RegularWallOptions walls = options.regular;
  if (building.sensor == SensorKind::sonar) walls.blind_corner_m = options.sonar_corner_m;
  const RegularOutlines regular =
      with_regular_walls(std::move(building.outlines), building.doors, walls);
  assembly.plan = plan_of(regular.outlines, regular.doors, no_bodies);
  if (regular.kept > 0) {
    assembly.plan.issues.push_back(
        {Severity::note, "", 0, "regular walls",
         std::to_string(regular.kept) + " of " + std::to_string(regular.outlines.size()) +
             " outlines are drawn as measured: straightened they would cross themselves"});
  }
}

}  // namespace roomatlas
