// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/map_room.hpp"
#include "roomatlas/draft/bare_floor.hpp"
#include "roomatlas/draft/columns.hpp"
#include "roomatlas/draft/door_leaves.hpp"
#include "roomatlas/draft/doors.hpp"
#include "roomatlas/draft/draft_plan.hpp"
#include "roomatlas/draft/furniture.hpp"
#include "roomatlas/draft/join_rooms.hpp"
#include "roomatlas/draft/straight_openings.hpp"
#include "roomatlas/draft/wall_gaps.hpp"
#include "roomatlas/rooms/mapped_building.hpp"
#include "roomatlas/rooms/partition_rooms.hpp"
#include "roomatlas/rooms/segment_rooms.hpp"

namespace roomatlas {

/// How evidence becomes a drafted plan.
struct DraftBuildingOptions {
  GatherOptions evidence;
  WallFaceOptions faces;
  OccupancyOptions occupancy;
  WallOptions walls;
  LeafOptions leaves;
  BareFloorOptions bare;
  WallGapOptions gaps;
  PartitionOptions partition;  ///< of what lasers saw
  SegmentOptions sonar_rooms;  ///< of what sonars heard; the smallest room is `partition`'s
  JoinRoomsOptions join;
  StraightOpeningOptions straight_openings;
  DraftOptions draft;
  ColumnOptions columns;
  DoorOptions doors;
  FurnitureOptions furniture;
  double min_unentered_m2 = 4.0;      ///< rooms that the robot did not enter are larger ...
  double min_unentered_share = 0.55;  ///< ... and this much of their edge was seen
};

/// A building as an architect would draw it, and what led there.
struct DraftedBuilding {
  Walls walls;
  Occupancy occupancy;
  RoomPartition partition;  ///< its rooms' numbers hold throughout
  std::vector<DraftedRoom> rooms;
  std::vector<Polygon> wall_bodies;
  std::vector<Door> doors;  ///< between drafted rooms
  std::vector<PlanEdge> edges;
  std::vector<PlanFurniture> furniture;
};

/// Drafts a building: faces of walls, walls, rooms, the lines on which their walls run, doors,
/// furniture, and what is known of each edge. Without a path (`evidence_of_map`) rooms are decided
/// on the floor as it is, and none is left out for not being entered.
/// @param jobs threads at once, see `for_each_index`
[[nodiscard]] DraftedBuilding draft_building(const BuildingEvidence& evidence,
                                             const DraftBuildingOptions& chosen, int jobs = 1);

/// The same as the rooms of a mission: numbered without gaps, with doors in the order of their
/// first crossing, and each room's outline as far as it was seen free.
/// @param map how outlines of free space are simplified
[[nodiscard]] MappedBuilding mapped_building_of(DraftedBuilding drafted,
                                                const BuildingEvidence& evidence,
                                                const RoomMapOptions& map);

/// The outline of what was seen free of each room, by its walls' surfaces where there are any.
[[nodiscard]] std::vector<PlacedOutline> measured_outlines(const DraftedBuilding& drafted,
                                                           const BuildingEvidence& evidence,
                                                           const RoomMapOptions& map);

}  // namespace roomatlas
