// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw_up.hpp"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "roomatlas/plan/room_ids.hpp"

namespace roomatlas {
namespace {

/// The visits of each room, in their order.
std::map<RoomId, std::vector<AsrId>> asrs_by_room(const std::map<AsrId, RoomId>& room_of_asr) {
  std::map<RoomId, std::vector<AsrId>> asrs;
  for (const auto& [asr, room] : room_of_asr) asrs[room].push_back(asr);
  return asrs;
}

}  // namespace

void draw_up(MappedBuilding building, const AssembleOptions& options, Assembly& assembly) {
  const std::map<RoomId, std::vector<AsrId>> asrs_of = asrs_by_room(building.room_of_asr);
  const auto plan_of = [&](const auto& outlines, const auto& placed_doors, const auto& bodies) {
    FloorPlan plan = merge(outlines, placed_doors, options.merge, bodies);
    for (PlanRoom& room : plan.rooms) {
      const auto asrs = asrs_of.find(room.id);
      room.asrs = asrs == asrs_of.end() ? std::vector<AsrId>() : asrs->second;
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
    const std::set<RoomId> rooms = room_ids(assembly.plan);
    std::erase_if(building.edges, [&](const PlanEdge& edge) {
      return !rooms.contains(edge.room);  // it has no place of its own
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
