// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/rooms/partition_rooms.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "partition/cut_building.hpp"
#include "partition/region_graph.hpp"
#include "partition/seen_only.hpp"

namespace roomatlas {
namespace {

constexpr double kNearPoseM = 0.5;  // a pose this near to a room's floor is in it

void check(const PartitionEvidence& evidence) {
  if (!(evidence.free.domain == evidence.obstacle.domain)) {
    throw std::invalid_argument("partition_rooms: free and obstacle have different domains");
  }
  if (!(evidence.frame.cell_m > 0.0)) {
    throw std::invalid_argument("partition_rooms: cell_m is not positive");
  }
}

/// The region nearest to a pose.
std::int32_t region_at(const Point2& at, const CellFrame& frame,
                       const Raster<std::int32_t>& region_of_cell) {
  const Cell center = frame.cell_of(at);
  const int reach = static_cast<int>(kNearPoseM / frame.cell_m);
  std::int32_t nearest = region_of_cell.get(center);
  double least = kNearPoseM / frame.cell_m;
  for (int dy = -reach; nearest == 0 && dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const std::int32_t here = region_of_cell.get({center.x + dx, center.y + dy});
      if (here == 0 || std::hypot(dx, dy) >= least) continue;
      least = std::hypot(dx, dy);
      nearest = here;
    }
  }
  return nearest;
}

/// Numbers regions as they are first named.
class Numbering {
 public:
  RoomId of(std::int32_t region) {
    if (region == 0) return 0;
    return number_of_.try_emplace(region, static_cast<RoomId>(number_of_.size()) + 1).first->second;
  }
  /// 0 for a region without a number.
  [[nodiscard]] RoomId find(std::int32_t region) const {
    const auto found = number_of_.find(region);
    return found == number_of_.end() ? 0 : found->second;
  }
  [[nodiscard]] RoomId count() const { return static_cast<RoomId>(number_of_.size()); }

 private:
  std::map<std::int32_t, RoomId> number_of_;
};

Opening opening_between(const PieceOpening& found, double probability, RoomId room_a, RoomId room_b,
                        const Raster<std::int32_t>& room_of_cell, const CellFrame& frame) {
  Opening opening;
  static_cast<Doorway&>(opening) = doorway_between(found.jambs);
  opening.width_m = found.width_m;
  opening.room_a = room_a;
  opening.room_b = room_b;
  opening.probability = probability;
  opening.is_driven = found.crossings > 0;
  // the way leads from a to b: asked on both sides, for a chord may run along one of them
  const Point2 ahead = direction(opening.frame_from_pivot.theta_rad);
  int agree = 0;
  for (int k = 1; k <= 8; ++k) {
    for (const double sign : {-1.0, 1.0}) {
      const RoomId here = room_of_cell.get(
          frame.cell_of(opening.frame_from_pivot.position() + sign * 0.05 * k * ahead));
      if (here == room_b) agree += sign > 0.0 ? 1 : -1;
      if (here == room_a) agree += sign > 0.0 ? -1 : 1;
    }
  }
  if (agree < 0) {
    static_cast<Doorway&>(opening) = doorway_between(Segment2{found.jambs.b, found.jambs.a});
    opening.width_m = found.width_m;
  }
  return opening;
}

/// Openings on one chord as one: it may run along several pieces of a room.
std::vector<PieceOpening> whole_openings(const std::vector<const PieceOpening*>& parts) {
  std::vector<PieceOpening> whole;
  for (const PieceOpening* part : parts) {
    const auto same = std::find_if(whole.begin(), whole.end(), [&](const PieceOpening& other) {
      return part->is_on_chord && other.is_on_chord && part->jambs.a == other.jambs.a &&
             part->jambs.b == other.jambs.b;
    });
    if (same == whole.end()) {
      whole.push_back(*part);
      continue;
    }
    same->width_m = std::min(same->width_m + part->width_m, (same->jambs.b - same->jambs.a).norm());
    same->crossings += part->crossings;
  }
  return whole;
}

/// The openings between numbered rooms.
std::vector<Opening> openings_of(const RegionGraph& graph, const DoorQueue& doors,
                                 const Numbering& numbering, const RoomPartition& rooms,
                                 const CellFrame& frame) {
  std::vector<Opening> openings;
  for (const RegionGraph::Pair& pair : graph.pairs()) {
    RoomId room_a = numbering.find(pair.first);
    RoomId room_b = numbering.find(pair.second);
    if (room_a == 0 || room_b == 0) continue;
    if (room_a > room_b) std::swap(room_a, room_b);
    for (const PieceOpening& found : whole_openings(graph.openings(pair))) {
      openings.push_back(opening_between(found, doors.probability(pair), room_a, room_b,
                                         rooms.room_of_cell, frame));
    }
  }
  std::stable_sort(openings.begin(), openings.end(), [](const Opening& a, const Opening& b) {
    return std::pair(a.room_a, a.room_b) < std::pair(b.room_a, b.room_b);
  });
  return openings;
}

RoomPartition named_rooms(const PartitionEvidence& evidence, CutBuilding cut,
                          const RegionGraph& graph, const DoorQueue& doors, double min_room_m2) {
  const std::set<std::int32_t> not_known =
      regions_not_known(cut, graph, evidence.building_from_robot);
  const auto is_room = [&](std::int32_t region) {
    return graph.region(region).area_m2 >= min_room_m2 && !not_known.contains(region);
  };
  Raster<std::int32_t> region_of_cell = std::move(cut.pieces.piece_of_cell);
  for (std::int32_t& value : region_of_cell.values) {
    value = graph.region_of(value);
    if (!is_room(value)) value = 0;
  }
  Numbering numbering;
  RoomPartition result;
  for (const Pose2& pose : evidence.building_from_robot) {
    result.room_of_pose.push_back(
        numbering.of(region_at(pose.position(), evidence.frame, region_of_cell)));
  }
  result.entered_rooms = numbering.count();
  result.room_of_cell = Raster<std::int32_t>(evidence.free.domain, 0);
  for_each_cell(region_of_cell.domain, [&](const Cell& cell) {
    if (region_of_cell[cell] == 0 || !result.room_of_cell.domain.contains(cell)) return;
    result.room_of_cell[cell] = static_cast<std::int32_t>(numbering.of(region_of_cell[cell]));
  });
  result.rooms = numbering.count();
  result.openings = openings_of(graph, doors, numbering, result, evidence.frame);
  return result;
}

}  // namespace

RoomPartition partition_rooms(const PartitionEvidence& evidence, const PartitionOptions& options) {
  check(evidence);
  CutBuilding cut = cut_building(evidence, options);
  RegionGraph graph(cut.pieces, cut.floor.frame, cut.openings);
  const JoinOptions join = join_options(options, !evidence.building_from_robot.empty());
  const DoorQueue doors = join_to_rooms(graph, learned_door_weights(), join);
  return named_rooms(evidence, std::move(cut), graph, doors, join.min_room_m2);
}

}  // namespace roomatlas
