// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "roomatlas/draft/draft_building.hpp"

namespace roomatlas {
namespace {

/// Rooms by their number in the partition, numbered anew without gaps.
std::map<RoomId, RoomId> numbers_of(const std::vector<DraftedRoom>& rooms) {
  std::map<RoomId, RoomId> number_of;
  for (const DraftedRoom& room : rooms) {
    number_of.emplace(room.id, static_cast<RoomId>(number_of.size()) + 1);
  }
  return number_of;
}

/// The room in which most poses of each ASR lie; poses of no room do not count, unless all are.
std::map<AsrId, RoomId> rooms_of_asrs(const BuildingEvidence& evidence,
                                      const std::vector<RoomId>& room_of_pose,
                                      const std::map<RoomId, RoomId>& number_of) {
  std::map<AsrId, std::map<RoomId, int>> votes;
  for (std::size_t i = 0; i < room_of_pose.size(); ++i) {
    const auto number = number_of.find(room_of_pose[i]);
    auto& of_asr = votes[evidence.asr_of_pose[i]];
    if (number != number_of.end()) ++of_asr[number->second];
  }
  std::map<AsrId, RoomId> room_of;
  RoomId last = number_of.empty() ? 0 : number_of.begin()->second;
  for (const auto& [asr, rooms] : votes) {
    const auto most =
        std::max_element(rooms.begin(), rooms.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most != rooms.end()) last = most->first;
    room_of[asr] = last;  // an ASR in no room counts to the one before
  }
  return room_of;
}

/// Doors in the order in which the robot first went through them, then those it only saw.
std::vector<Door> in_order_of_crossing(const std::vector<Door>& doors,
                                       const BuildingEvidence& evidence) {
  struct Found {
    Door door;
    std::size_t first_pose = 0;
  };
  const auto& path = evidence.building_from_robot;
  std::vector<Found> found;
  for (const Door& door : doors) {
    Found next{door, path.size()};
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (!crossing_fraction({path[i - 1].position(), path[i].position()}, door.jambs)) continue;
      next.first_pose = std::min(next.first_pose, i);
      next.door.crossings.push_back(evidence.asr_of_pose[i]);
    }
    next.door.is_driven = next.first_pose < path.size();
    found.push_back(std::move(next));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.first_pose < b.first_pose; });
  std::vector<Door> sorted;
  sorted.reserve(found.size());
  for (Found& one : found) sorted.push_back(std::move(one.door));
  return sorted;
}

}  // namespace

MappedBuilding mapped_building_of(DraftedBuilding drafted, const BuildingEvidence& evidence,
                                  const RoomMapOptions& map) {
  const std::map<RoomId, RoomId> number_of = numbers_of(drafted.rooms);
  MappedBuilding building;
  building.is_drafted = true;
  building.sensor = evidence.kind;
  building.room_of_asr = rooms_of_asrs(evidence, drafted.partition.room_of_pose, number_of);
  building.doors = in_order_of_crossing(drafted.doors, evidence);
  for (Door& door : building.doors) {
    door.room_a = number_of.at(*door.room_a);
    door.room_b = number_of.at(*door.room_b);
  }
  const auto first_asr = [&](RoomId room) -> AsrId {
    const auto first = std::find_if(building.room_of_asr.begin(), building.room_of_asr.end(),
                                    [&](const auto& entry) { return entry.second == room; });
    return first == building.room_of_asr.end() ? 0 : first->first;
  };
  for (const DraftedRoom& room : drafted.rooms) {
    const RoomId number = number_of.at(room.id);
    building.outlines.push_back({first_asr(number), number, room.outline});
  }
  for (PlacedOutline& outline : measured_outlines(drafted, evidence, map)) {
    outline.room = number_of.at(outline.room);
    outline.asr = first_asr(outline.room);
    building.measured_outlines.push_back(std::move(outline));
  }
  for (PlanEdge& edge : drafted.edges) edge.room = number_of.at(edge.room);
  building.edges = std::move(drafted.edges);
  building.wall_bodies = std::move(drafted.wall_bodies);
  building.furniture = std::move(drafted.furniture);
  return building;
}

}  // namespace roomatlas
