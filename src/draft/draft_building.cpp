// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/draft_building.hpp"

#include <algorithm>
#include <set>

#include "roomatlas/draft/edges.hpp"

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
                              drafted.occupancy, SensorKind::laser, options.walls);
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
  const Occupancy bare = bare_floor(drafted.walls, drafted.occupancy, options.bare);
  PartitionEvidence known;
  known.frame = bare.frame;
  known.free = bare.free;
  known.obstacle = bare.obstacle;
  known.building_from_robot = evidence.building_from_robot;
  known.wall_gaps = find_wall_gaps(drafted.walls, drafted.occupancy, options.gaps);
  RoomPartition partition = partition_rooms(known, options.partition);
  join_rooms(bare, options.join, partition);
  return partition;
}

/// What sonars heard leaves gaps in walls, so that rooms are decided by where the robot drove.
RoomPartition segmented(const Occupancy& occupancy, const BuildingEvidence& evidence,
                        const DraftBuildingOptions& options) {
  SegmentOptions segment = options.sonar_rooms;
  segment.min_room_m2 = options.partition.min_driven_room_m2;
  const BuildingGrid grid =
      building_grid(evidence.coarse, evidence.kind, evidence.building_from_robot,
                    evidence.footprint, segment.grid);
  const RoomSegmentation rooms = segment_rooms(grid, evidence.building_from_robot, segment);
  RoomPartition partition;
  partition.rooms = rooms.rooms;
  partition.room_of_pose = rooms.room_of_pose;
  partition.room_of_cell = Raster<std::int32_t>(occupancy.free.box, 0);
  for_each_cell(occupancy.free.box, [&](const Cell& cell) {
    partition.room_of_cell[cell] =
        static_cast<std::int32_t>(rooms.at(rooms.frame.cell_of(occupancy.frame.center_of(cell))));
  });
  for (const Door& door : rooms.openings) {
    if (!door.is_between_rooms() || door.room_a == door.room_b) continue;
    Opening& opening = partition.openings.emplace_back(Opening{door, 1.0});
    static_cast<Doorway&>(opening) = with_jambs_at_peaks(door, evidence.coarse);
  }
  return partition;
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

}  // namespace

DraftedBuilding draft_building(const BuildingEvidence& evidence,
                               const DraftBuildingOptions& options) {
  DraftedBuilding drafted;
  std::vector<WallFace> faces =
      confirmed_faces(find_wall_faces(evidence, options.faces), evidence, options.walls);
  drafted.occupancy = occupancy_of(evidence, faces, options.occupancy);
  drafted.walls = build_walls(std::move(faces), drafted.occupancy, evidence.kind, options.walls);
  std::vector<DoorLeaf> leaves;
  if (evidence.kind == SensorKind::laser && !evidence.building_from_robot.empty()) {
    leaves = take_leaves(options, drafted);
  }
  drafted.partition = evidence.kind == SensorKind::sonar
                          ? segmented(drafted.occupancy, evidence, options)
                          : partitioned(drafted, evidence, options);
  RoomSeeds seeds{drafted.partition.room_of_cell, {}};
  for (const Opening& opening : drafted.partition.openings) {
    seeds.openings.push_back(straightened(opening, drafted.walls, options.straight_openings));
  }
  DraftOptions on_lines = options.draft;
  if (evidence.building_from_robot.empty()) on_lines.hidden_cost = 0.0;  // rooms hold furniture too
  Draft draft = draft_plan(drafted.walls, drafted.occupancy, seeds, on_lines);
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
