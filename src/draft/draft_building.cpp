// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/draft_building.hpp"

#include <algorithm>
#include <set>

#include "driven_gaps.hpp"
#include "roomatlas/draft/edges.hpp"
#include "sonar_rooms.hpp"
#include "sonar_walls.hpp"

namespace roomatlas {
namespace {

/// Finds door leaves that stand open, and takes them out of the walls and of what stands on the
/// floor. Of a finished map nothing says what else was seen where they stand.
std::vector<DoorLeaf> take_leaves(const DraftBuildingOptions& options, DraftedBuilding& drafted) {
  const std::vector<Segment2> gaps = find_wall_gaps(drafted.walls, drafted.occupancy, options.gaps);
  std::vector<DoorLeaf> leaves = find_leaves(gaps, drafted.occupancy, options.leaves);
  if (leaves.empty()) return leaves;
  clear_leaves(leaves, drafted.occupancy);
  drafted.walls = build_walls(without_leaves(std::move(drafted.walls.faces), leaves),
                              drafted.occupancy, options.walls);
  return leaves;
}

/// Rooms of the bare floor; of a finished map those of its floor as it is, for the partition has
/// learned from such maps, furniture included, what parts rooms.
RoomPartition partitioned(const DraftedBuilding& drafted, const BuildingEvidence& evidence,
                          const DraftBuildingOptions& options) {
  if (evidence.building_from_robot.empty()) {
    const Occupancy& map = drafted.occupancy;
    return partition_rooms({map.frame, map.free, map.obstacle, {}, {}}, options.partition);
  }
  Occupancy bare = bare_floor(drafted.walls, drafted.occupancy, options.bare);
  PartitionEvidence known;
  known.frame = bare.frame;
  known.free = std::move(bare.free);  // lent: masks of a large building are large
  known.obstacle = std::move(bare.obstacle);
  known.building_from_robot = evidence.building_from_robot;
  known.wall_gaps = find_wall_gaps(drafted.walls, drafted.occupancy, options.gaps);
  RoomPartition partition = partition_rooms(known, options.partition);
  bare.free = std::move(known.free);
  bare.obstacle = std::move(known.obstacle);
  join_rooms(bare, options.join, partition);
  return partition;
}

/// Takes what stands in the swing of doors out of the walls and of what stands on the floor: there
/// sonars hear leaves that stand open, at any angle.
void take_swings(const BuildingEvidence& evidence, const DraftBuildingOptions& options,
                 DraftedBuilding& drafted) {
  const std::vector<bool> is_wall = sonar_walls(drafted.walls, drafted.occupancy, options.bare);
  const std::vector<Segment2> gaps =
      driven_gaps(drafted.walls, is_wall, evidence.building_from_robot);
  if (gaps.empty()) return;
  clear_swings(drafted.walls, is_wall, gaps, drafted.occupancy);
  drafted.walls =
      build_walls(without_swings(drafted.walls, is_wall, gaps), drafted.occupancy, options.walls);
}

/// Columns are walls: holes in their rooms' floor.
void stand_columns(const BuildingEvidence& evidence, const DraftBuildingOptions& options,
                   DraftedBuilding& drafted) {
  const auto pieces = find_furniture(drafted.rooms, drafted.occupancy, options.furniture);
  for (const Ring& column : find_columns(pieces, evidence.surfaces, options.columns)) {
    for (DraftedRoom& room : drafted.rooms) {
      if (!contains(room.outline, column.front())) continue;
      room.outline.holes.emplace_back(column.rbegin(), column.rend());
      drafted.wall_bodies.push_back({column, {}});
      break;
    }
  }
}

/// The share of a room's edge along which an obstacle was seen.
double measured_share(RoomId room, const std::vector<PlanEdge>& edges) {
  double measured_m = 0.0;
  double all_m = 0.0;
  for (const PlanEdge& edge : edges) {
    if (edge.room != room) continue;
    const double length_m = (edge.line.b - edge.line.a).norm();
    all_m += length_m;
    if (edge.evidence == WallEvidence::measured) measured_m += length_m;
  }
  return all_m > 0.0 ? measured_m / all_m : 0.0;
}

/// Leaves out rooms that are glimpses through doors and windows, and edges and doors of rooms that
/// were not drafted. Of a finished map nothing says what was entered.
void drop_glimpses(const DraftBuildingOptions& options, DraftedBuilding& drafted) {
  const std::vector<RoomId>& entered = drafted.partition.room_of_pose;
  std::erase_if(drafted.rooms, [&](const DraftedRoom& room) {
    if (entered.empty()) return false;
    if (std::find(entered.begin(), entered.end(), room.id) != entered.end()) return false;
    return area(room.outline) < options.min_unentered_m2 ||
           measured_share(room.id, drafted.edges) < options.min_unentered_share;
  });
  std::set<RoomId> kept;
  for (const DraftedRoom& room : drafted.rooms) kept.insert(room.id);
  std::erase_if(drafted.edges, [&](const PlanEdge& edge) { return !kept.contains(edge.room); });
  std::erase_if(drafted.doors, [&](const Door& door) {
    return !kept.contains(*door.room_a) || !kept.contains(*door.room_b);
  });
}

/// The options as they are for a map without a path, and for sonars.
DraftBuildingOptions options_for(const BuildingEvidence& evidence, DraftBuildingOptions options) {
  if (evidence.building_from_robot.empty())
    options.draft.hidden_cost = 0.0;  // rooms hold furniture
  if (evidence.kind != SensorKind::sonar) return options;
  options.draft.faint_cost = options.draft.sonar_faint_cost;
  options.draft.deep_unseen_cost = options.draft.sonar_deep_unseen_cost;
  return options;
}

}  // namespace

DraftedBuilding draft_building(const BuildingEvidence& evidence, const DraftBuildingOptions& chosen,
                               int jobs) {
  const DraftBuildingOptions options = options_for(evidence, chosen);
  DraftedBuilding drafted;
  std::vector<WallFace> faces =
      confirmed_faces(find_wall_faces(evidence, options.faces, jobs), evidence, options.walls);
  drafted.occupancy = occupancy_of(evidence, faces, options.occupancy);
  drafted.walls = build_walls(std::move(faces), drafted.occupancy, options.walls);
  std::vector<DoorLeaf> leaves;
  if (evidence.kind == SensorKind::laser && !evidence.building_from_robot.empty()) {
    leaves = take_leaves(options, drafted);
  }
  if (evidence.kind == SensorKind::sonar) take_swings(evidence, options, drafted);
  drafted.partition = evidence.kind == SensorKind::sonar
                          ? sonar_rooms(drafted.walls, drafted.occupancy, evidence, options)
                          : partitioned(drafted, evidence, options);
  RoomSeeds seeds{drafted.partition.room_of_cell, {}};
  for (const Opening& opening : drafted.partition.openings) {
    seeds.openings.push_back(straightened(opening, drafted.walls, options.straight_openings));
  }
  Draft draft = draft_plan(drafted.walls, drafted.occupancy, seeds, options.draft);
  drafted.rooms = std::move(draft.rooms);
  drafted.wall_bodies = std::move(draft.wall_bodies);
  stand_columns(evidence, options, drafted);
  drafted.edges = edges_of(drafted.rooms, drafted.walls, evidence, drafted.occupancy);
  drafted.doors = placed_doors(seeds.openings, drafted.walls, evidence, options.doors);
  hang_leaves(leaves, drafted.doors);
  drop_glimpses(options, drafted);
  drafted.furniture = find_furniture(drafted.rooms, drafted.occupancy, options.furniture);
  return drafted;
}

}  // namespace roomatlas
