// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_rooms.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "driven_gaps.hpp"
#include "sonar_floor.hpp"
#include "sonar_walls.hpp"
#include "wall_openings.hpp"

namespace roomatlas {
namespace {

constexpr double kSameDoor_m = 0.7;  // openings whose middles are nearer are one ...
constexpr double kSureGap_m = 1.1;   // in a wider gap wall beside the door was not heard
constexpr double kSameWall_m = 0.4;  // ... and so are those in the faces of one wall
constexpr double kSureDoor = 0.93;   // the probability of an opening that is in no known wall ...
constexpr double kLikelyDoor = 0.5;  // ... and of one that is, where it is wider than this
constexpr double kDoor_m = 1.6;
constexpr double kFurnished = 0.4;  // share of what was heard that is on no wall

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

/// Rooms by where the robot drove, parted by the given openings alone.
RoomPartition by_openings(const BuildingGrid& grid, const ReflectionMap& coarse,
                          const std::vector<Doorway>& openings, const std::vector<Pose2>& path,
                          const SegmentOptions& options) {
  RoomSegmentation rooms = segment_rooms(grid, openings, path, options);
  RoomPartition partition;
  partition.rooms = rooms.rooms;
  partition.room_of_pose = rooms.room_of_pose;
  partition.room_of_cell = std::move(rooms.room_of_cell);
  for (const Door& door : rooms.openings) {
    if (!door.is_between_rooms() || door.room_a == door.room_b) continue;
    Opening& opening = partition.openings.emplace_back(Opening{door, 1.0});
    static_cast<Doorway&>(opening) = with_jambs_at_peaks(door, coarse);
  }
  return partition;
}

/// Leaves out gaps in what was heard of walls: openings through which nobody drove, and those
/// beside a door, unless they were found in walls.
void drop_gaps(const std::vector<Doorway>& in_walls, RoomPartition& partition) {
  const std::vector<Opening> all = partition.openings;
  const std::set<RoomId> entered(partition.room_of_pose.begin(), partition.room_of_pose.end());
  const auto apart_m = [](const Doorway& one, const Doorway& other) {
    return (middle_of(one) - middle_of(other)).norm();
  };
  std::erase_if(partition.openings, [&](const Opening& opening) {
    const bool is_used = opening.is_driven || !entered.contains(*opening.room_a) ||
                         !entered.contains(*opening.room_b);
    if (!is_used) return true;
    const auto nearest = std::min_element(in_walls.begin(), in_walls.end(),
                                          [&](const Doorway& one, const Doorway& other) {
                                            return apart_m(opening, one) < apart_m(opening, other);
                                          });
    if (nearest == in_walls.end() || apart_m(opening, *nearest) >= kSameDoor_m) {
      return !opening.is_driven;
    }
    return std::any_of(all.begin(), all.end(), [&](const Opening& other) {
      return apart_m(other, *nearest) < apart_m(opening, *nearest);
    });
  });
}

/// Rooms by the shape of the floor, as those of lasers; openings in walls that are not known have
/// to be likelier doors.
RoomPartition by_shape(const WallOpenings& judge, const BuildingGrid& grid,
                       const ReflectionMap& coarse, const std::vector<Doorway>& openings,
                       const std::vector<Pose2>& path, const PartitionOptions& options) {
  PartitionEvidence known{grid.frame, grid.free, grid.obstacle, path, {}};
  for (const Doorway& one : openings) known.wall_gaps.push_back(one.jambs);
  RoomPartition partition = partition_rooms(known, options);
  for (Opening& opening : partition.openings) {
    static_cast<Doorway&>(opening) = with_jambs_at_peaks(opening, coarse);
  }
  const auto is_door = [&](const Opening& opening) {
    if (opening.probability >= kSureDoor) return true;
    if (!judge.is_in_wall(opening.jambs)) return false;
    return opening.width_m <= kDoor_m || opening.probability >= kLikelyDoor;
  };
  std::set<std::pair<RoomId, RoomId>> parted;
  for (const Opening& opening : partition.openings) {
    if (is_door(opening)) parted.insert({*opening.room_a, *opening.room_b});
  }
  join_rooms(
      [&](const Opening& opening) {
        return parted.contains({*opening.room_a, *opening.room_b});
      },
      partition);
  drop_gaps(openings, partition);
  return partition;
}

/// The rooms on the cells of the occupancy.
RoomPartition on_cells_of(const Occupancy& occupancy, const CellFrame& frame,
                          RoomPartition partition) {
  Raster<std::int32_t> room_of_cell(occupancy.free.domain, 0);
  for_each_cell(occupancy.free.domain, [&](const Cell& cell) {
    const Point2 at = occupancy.frame.center_of(cell);
    room_of_cell[cell] = partition.room_of_cell.get(frame.cell_of(at));
  });
  partition.room_of_cell = std::move(room_of_cell);
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
  // What is left of much furniture would part the floor like walls.
  const RoomPartition rooms =
      share_on_no_wall(walls, is_wall, heard) < kFurnished
          ? by_shape(judge, grid, evidence.coarse, openings, path, options.partition)
          : by_openings(grid, evidence.coarse, openings, path, segment);
  return on_cells_of(occupancy, grid.frame, rooms);
}

}  // namespace roomatlas
