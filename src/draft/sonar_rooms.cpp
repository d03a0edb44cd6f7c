// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_rooms.hpp"

#include <algorithm>

#include "driven_gaps.hpp"
#include "sonar_floor.hpp"
#include "sonar_walls.hpp"
#include "wall_openings.hpp"

namespace roomatlas {
namespace {

constexpr double kSameDoor_m = 0.7;  // openings whose middles are nearer are one ...
constexpr double kSureGap_m = 1.1;   // in a wider gap wall beside the door was not heard
constexpr double kSameWall_m = 0.4;  // ... and so are those in the faces of one wall

Point2 middle_of(const Doorway& opening) { return opening.frame_from_pivot.position(); }

bool is_near_any(const Doorway& one, const std::vector<Doorway>& others) {
  return std::any_of(others.begin(), others.end(), [&](const Doorway& other) {
    return (middle_of(one) - middle_of(other)).norm() < kSameDoor_m ||
           std::min(distance(other.jambs, middle_of(one)), distance(one.jambs, middle_of(other))) <
               kSameWall_m;
  });
}

/// Openings in walls: gaps that were driven through; openings of the floor without furniture; and
/// those of doors' width that are gone with it, for it may have been a short piece of wall.
std::vector<Doorway> openings_in_walls(const WallOpenings& judge, const BuildingGrid& heard,
                                       const BuildingGrid& grid, const std::vector<Segment2>& gaps,
                                       const SegmentOptions& options) {
  std::vector<Doorway> openings;
  const auto add = [&](const Doorway& one) {
    if (judge.is_in_wall(one.jambs) && !is_near_any(one, openings)) openings.push_back(one);
  };
  const auto is_sure = [](const Segment2& gap) { return (gap.b - gap.a).norm() <= kSureGap_m; };
  for (const Segment2& gap : gaps) {
    if (is_sure(gap)) add(doorway_between(gap));
  }
  const std::vector<Doorway> found = openings_between_rooms(grid, options);
  for (const Doorway& one : found) add(one);
  for (const Doorway& one : openings_between_rooms(heard, options)) {
    if (one.width_m <= options.doors.max_width_m && !is_near_any(one, found)) add(one);
  }
  for (const Segment2& gap : gaps) {
    if (!is_sure(gap)) add(doorway_between(gap));
  }
  return openings;
}

RoomPartition partition_of(const RoomSegmentation& rooms, const CellFrame& frame,
                           const CellBox& box, const ReflectionMap& coarse) {
  RoomPartition partition;
  partition.rooms = rooms.rooms;
  partition.room_of_pose = rooms.room_of_pose;
  partition.room_of_cell = Raster<std::int32_t>(box, 0);
  for_each_cell(box, [&](const Cell& cell) {
    partition.room_of_cell[cell] =
        static_cast<std::int32_t>(rooms.at(rooms.frame.cell_of(frame.center_of(cell))));
  });
  for (const Door& door : rooms.openings) {
    if (!door.is_between_rooms() || door.room_a == door.room_b) continue;
    Opening& opening = partition.openings.emplace_back(Opening{door, 1.0});
    static_cast<Doorway&>(opening) = with_jambs_at_peaks(door, coarse);
  }
  return partition;
}

}  // namespace

RoomPartition sonar_rooms(const Walls& walls, const Occupancy& occupancy,
                          const BuildingEvidence& evidence, const DraftBuildingOptions& options) {
  const std::vector<Pose2>& path = evidence.building_from_robot;
  SegmentOptions segment = options.sonar_rooms;
  segment.min_room_m2 = options.partition.min_driven_room_m2;
  const BuildingGrid heard =
      building_grid(evidence.coarse, evidence.kind, path, evidence.footprint, segment.grid);
  const std::vector<bool> is_wall = sonar_walls(walls, occupancy, options.bare);
  const Occupancy bare = bare_floor(walls, is_wall, occupancy, options.bare);
  BuildingGrid grid = heard;
  take_furniture_out(walls, is_wall, occupancy, bare, grid);
  find_passable(path, segment.grid.margin_m, grid);
  const WallOpenings judge(walls, is_wall, bare, heard);
  const std::vector<Doorway> openings =
      openings_in_walls(judge, heard, grid, driven_gaps(walls, is_wall, path), segment);
  for (const Doorway& one : openings) {
    close_beside(one.jambs, kLongestStub_m, grid);
    if (judge.is_among_obstacles(one.jambs)) {
      restore_beside(judge.on_line_of_obstacles(one.jambs), heard, grid);
    }
  }
  return partition_of(segment_rooms(grid, openings, path, segment), occupancy.frame,
                      occupancy.free.box, evidence.coarse);
}

}  // namespace roomatlas
