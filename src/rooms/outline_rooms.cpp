// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/rooms/outline_rooms.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "roomatlas/asr/load.hpp"
#include "roomatlas/rooms/doors.hpp"

namespace roomatlas {
namespace {

constexpr double kDoorReachM = 1.0;  // doors this near an outline are cut into it

/// A door of the building as an exit of an ASR: theta points away from the ASR's path.
Exit as_exit_of(const Asr& asr, const Pose2& asr_from_door, double width_m) {
  const auto nearest = std::min_element(
      asr.path.begin(), asr.path.end(), [&](const PathSample& a, const PathSample& b) {
        return (a.asr_from_robot.position() - asr_from_door.position()).squaredNorm() <
               (b.asr_from_robot.position() - asr_from_door.position()).squaredNorm();
      });
  Pose2 asr_from_pivot = asr_from_door;
  const Point2 path_at_door = inverse(asr_from_door) * nearest->asr_from_robot.position();
  if (path_at_door.x() > 0.0) {
    asr_from_pivot.theta_rad = wrap_angle(asr_from_door.theta_rad + kPi);
  }
  return {doorway_at(asr_from_pivot, width_m), PassageKind::doorway, false, std::nullopt, 0.0};
}

using DoorsOfRooms = std::map<RoomId, std::vector<Door>>;

/// The doors of each room, in their order.
DoorsOfRooms by_room(const std::vector<Door>& doors) {
  DoorsOfRooms of_rooms;
  for (const Door& door : doors) {
    of_rooms[*door.room_a].push_back(door);
    if (door.room_b != door.room_a) of_rooms[*door.room_b].push_back(door);
  }
  return of_rooms;
}

/// The doors of an ASR's room near its outline that its own visit did not go through.
std::vector<Exit> other_doors_of(const Asr& asr, RoomId room, const Pose2& building_from_asr,
                                 const DoorsOfRooms& doors) {
  std::vector<Exit> others;
  const auto of_room = doors.find(room);
  if (of_room == doors.end()) return others;
  for (const Door& door : of_room->second) {
    const Pose2 asr_from_door = inverse(building_from_asr) * door.frame_from_pivot;
    const Point2 at = asr_from_door.position();
    const bool is_near = contains(asr.outline_asr, at) ||
                         distance_to_boundary(asr.outline_asr.outer, at) <= kDoorReachM;
    const bool is_own = std::any_of(asr.exits.begin(), asr.exits.end(), [&](const Exit& exit) {
      return exit.kind == PassageKind::doorway &&
             (exit.frame_from_pivot.position() - at).norm() <= kDoorReachM;
    });
    if (is_near && !is_own) others.push_back(as_exit_of(asr, asr_from_door, door.width_m));
  }
  return others;
}

/// The ASR's outline, cut at these doors too.
Polygon outline_cut_at(const std::vector<Exit>& others, const Asr& asr, const AsrSource& source,
                       const RobotFootprint& footprint, const OutlineRoomOptions& options) {
  if (others.empty()) return asr.outline_asr;
  const Asr whole = source.get(asr.id, AsrDetail::readings);
  if (whole.readings.empty()) return asr.outline_asr;
  std::vector<Exit> exits = asr.exits;
  exits.insert(exits.end(), others.begin(), others.end());
  return map_room(whole.path, whole.readings, exits, footprint, options.map).outline;
}

}  // namespace

MappedBuilding rooms_by_outlines(const AsrSource& source, const RoomGraph& graph,
                                 const Placement& placement, const RobotFootprint& footprint,
                                 const OutlineRoomOptions& options, const Progress& progress) {
  const std::vector<Asr> asrs = load(source, AsrDetail::path);
  MappedBuilding building;
  building.room_of_asr = assign_rooms(asrs, graph, placement, options.rooms);
  building.doors = doors_of(asrs, graph, placement, building.room_of_asr);
  const DoorsOfRooms doors_of_rooms = by_room(building.doors);
  for (const Asr& asr : asrs) {
    report(progress, "outline", share_of(building.outlines.size(), asrs.size()));
    const RoomId room = building.room_of_asr.at(asr.id);
    const Pose2& building_from_asr = placement.at(asr.id);
    std::vector<Exit> others;
    if (options.map_again) others = other_doors_of(asr, room, building_from_asr, doors_of_rooms);
    const Polygon outline = outline_cut_at(others, asr, source, footprint, options);
    building.outlines.push_back({asr.id, room, transformed(building_from_asr, outline)});
  }
  return building;
}

}  // namespace roomatlas
