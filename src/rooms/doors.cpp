// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/rooms/doors.hpp"

#include "roomatlas/core/median.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace roomatlas {
namespace {

constexpr double kSameDoorM = 0.8;  // crossings between two rooms this near are one door; larger
                                    // joins two doors side by side

/// One crossing, as the first draft of a door.
struct Crossing {
  AsrId to = 0;
  Pose2 building_from_pivot;
  double width_m = 0.0;
  RoomId from_room = 0;
  RoomId to_room = 0;
};

std::vector<Crossing> crossings_between_rooms(const std::vector<Asr>& asrs,
                                              const Placement& placement,
                                              const std::map<AsrId, RoomId>& room_of_asr) {
  std::vector<Crossing> crossings;
  for (const Asr& asr : asrs) {
    for (const Exit& exit : asr.exits) {
      if (exit.is_entry || exit.kind != PassageKind::doorway || !exit.neighbor) continue;
      if (!placement.contains(*exit.neighbor)) continue;
      const RoomId from_room = room_of_asr.at(asr.id);
      const RoomId to_room = room_of_asr.at(*exit.neighbor);
      if (from_room == to_room) continue;
      crossings.push_back(
          {*exit.neighbor, placement.at(*exit.neighbor), exit.width_m, from_room, to_room});
    }
  }
  return crossings;
}

using AsrPairs = std::set<std::pair<AsrId, AsrId>>;  // the smaller id first

AsrPairs recognised_pairs(const RoomGraph& graph) {
  AsrPairs pairs;
  for (const PassageEdge& edge : graph.edges) {
    if (edge.source == EdgeSource::recognised) pairs.insert(std::minmax(edge.from, edge.to));
  }
  return pairs;
}

/// Asked of crossings between the same two rooms.
bool is_same_door(const Crossing& a, const Crossing& b, const AsrPairs& recognised) {
  const double apart_m =
      (a.building_from_pivot.position() - b.building_from_pivot.position()).norm();
  return apart_m <= kSameDoorM || recognised.contains(std::minmax(a.to, b.to));
}

/// Turns a crossing so that it goes the way of the first.
Pose2 the_way_of(const Crossing& crossing, const Crossing& first) {
  Pose2 pose = crossing.building_from_pivot;
  if (crossing.from_room != first.from_room) pose.theta_rad = wrap_angle(pose.theta_rad + kPi);
  return pose;
}

Door averaged(const std::vector<Crossing>& crossings) {
  const Crossing& first = crossings.front();
  Point2 position = Point2::Zero();
  Point2 heading = Point2::Zero();
  std::vector<double> widths_m;
  Door door;
  for (const Crossing& crossing : crossings) {
    const Pose2 pose = the_way_of(crossing, first);
    position += pose.position() / static_cast<double>(crossings.size());
    heading += direction(pose.theta_rad);
    widths_m.push_back(crossing.width_m);
    door.crossings.push_back(crossing.to);
  }
  static_cast<Doorway&>(door) = doorway_at(
      {position.x(), position.y(), std::atan2(heading.y(), heading.x())}, median(widths_m));
  door.room_a = first.from_room;
  door.room_b = first.to_room;
  door.is_driven = true;
  return door;
}

}  // namespace

std::vector<Door> doors_of(const std::vector<Asr>& asrs, const RoomGraph& graph,
                           const Placement& placement, const std::map<AsrId, RoomId>& room_of_asr) {
  const AsrPairs recognised = recognised_pairs(graph);
  std::vector<std::vector<Crossing>> groups;
  std::map<std::pair<RoomId, RoomId>, std::vector<std::size_t>> groups_between;  // two rooms
  for (const Crossing& crossing : crossings_between_rooms(asrs, placement, room_of_asr)) {
    auto& between = groups_between[std::minmax(crossing.from_room, crossing.to_room)];
    const auto same = std::find_if(between.begin(), between.end(), [&](std::size_t group) {
      return std::any_of(groups[group].begin(), groups[group].end(), [&](const Crossing& other) {
        return is_same_door(crossing, other, recognised);
      });
    });
    if (same != between.end()) {
      groups[*same].push_back(crossing);
    } else {
      between.push_back(groups.size());
      groups.push_back({crossing});
    }
  }
  std::vector<Door> doors;
  doors.reserve(groups.size());
  for (const auto& group : groups) doors.push_back(averaged(group));
  return doors;
}

}  // namespace roomatlas
