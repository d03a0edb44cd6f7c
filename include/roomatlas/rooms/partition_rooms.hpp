// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/grid/raster.hpp"
#include "roomatlas/plan/door.hpp"
#include "roomatlas/polyline/region.hpp"

namespace roomatlas {

/// What is known of a building, cell by cell; the masks share one domain.
struct PartitionEvidence {
  CellFrame frame;
  CellMask free{CellBox{}};      ///< seen, and no obstacle
  CellMask obstacle{CellBox{}};  ///< walls, furniture; what is in neither mask was not seen
  /// The mission's path, in its order. Empty for a finished map: then the free space is taken as it
  /// is; otherwise it is cleaned of what beams leave behind, and parts off the path are dropped.
  std::vector<Pose2> building_from_robot;
  /// Gaps in walls that are known otherwise, jamb to jamb: the floor is cut there whatever the
  /// cells around show. May be empty.
  std::vector<Segment2> wall_gaps;
};

struct PartitionOptions {
  double island_m = 1.2;               ///< obstacles that fit into a square of this side and stand
                                       ///< free are furniture; larger takes pillars with it
  double speck_m2 = 0.05;              ///< smaller holes in a mission's free space are noise
  double ray_width_m = 0.2;            ///< free strips narrower than this are single beams' traces
  double min_door_probability = 0.45;  ///< larger joins more
  double min_room_m2 = 2.0;            ///< smaller rooms belong to the room next door ...
  double min_driven_room_m2 = 2.5;     ///< ... and so do these, in a mission's map
  double min_room_radius_m = 0.5;      ///< a room holds a circle of this radius
};

/// An opening between two rooms; building metres. Its way leads from room_a to room_b.
struct Opening : Door {
  double probability = 0.0;  ///< that it parts two rooms, [0, 1]
};

struct RoomPartition {
  /// 0: no room; 1, 2, 3 ...: rooms on the path in the order in which it enters them, then the
  /// others by their lowest, then leftmost cell. Furniture that stands free is part of its room.
  Raster<std::int32_t> room_of_cell;
  RoomId rooms = 0;               ///< how many there are
  RoomId entered_rooms = 0;       ///< the path is in rooms 1 to this one; the others were only seen
  std::vector<Opening> openings;  ///< by their rooms' numbers
  std::vector<RoomId> room_of_pose;  ///< parallel to the path; 0 where no room is near
};

/// Cuts the free space of a finished map into rooms. It is first cut into far too many pieces:
/// along chords that continue walls through openings, and at the narrow places of what is left (the
/// distance transform flooded from its peaks). Then the two pieces whose common openings are least
/// likely doors are joined, again and again, until all that is left is a door. The likelihood is a
/// logistic function of a few figures of the openings and of the smaller piece, learned from
/// labelled maps (bench/rooms); nothing in it is tied to the axes of the map or to its cell size.
///
/// The method is this project's own. Related: M. Mielle, M. Magnusson, A. Lilienthal, "A method to
/// segment maps from different modalities using free space layout: MAORIS", ICRA 2018 (ripples of
/// the distance transform); M. Luperto et al., "Robust structure identification and room
/// segmentation of cluttered indoor environments from occupancy grid maps" (ROSE2), RA-L 2022 (wall
/// directions); R. Bormann et al., "Room segmentation: survey, implementation, and analysis", ICRA
/// 2016.
///
/// Without free space there are no rooms. Throws std::invalid_argument when the masks' domains
/// differ or cell_m is not positive. Not guaranteed: that a room is connected over cells' edges
/// alone.
[[nodiscard]] RoomPartition partition_rooms(const PartitionEvidence& evidence,
                                            const PartitionOptions& options = {});

}  // namespace roomatlas
