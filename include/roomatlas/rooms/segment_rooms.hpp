// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/asr/asr.hpp"
#include "roomatlas/grid/raster.hpp"
#include "roomatlas/rooms/openings.hpp"

namespace roomatlas {

struct SegmentOptions {
  BuildingGridOptions grid;
  OpeningOptions doors;
  double max_window_m = 2.5;  ///< a wider opening that the robot did not go through is none
  double see_m = 12.0;        ///< two places this near that see each other are in one room
  double min_room_m2 = 2.5;   ///< smaller rooms belong to the room next door
};

/// The rooms of a mission whose poses are known.
struct RoomSegmentation {
  CellFrame frame;
  Raster<std::int32_t> room_of_cell;  ///< 0: no room. Half of RoomId's size, for there are millions
  std::vector<RoomId> room_of_pose;   ///< parallel to the path; 1, 2, 3 ... as they were entered
  std::vector<Door> openings;  ///< doors between rooms, and openings into what was not entered
  RoomId rooms = 0;            ///< how many there are

  [[nodiscard]] RoomId at(const Cell& cell) const { return room_of_cell.get(cell); }
};

/// Decides what is one room, from everything that the mission saw: places on the path belong
/// together when one was driven to from the other, or sees it, without crossing an opening. An
/// opening whose two sides are the same room by another way is no door (furniture), nor is one to
/// a room that is too small, unless that is a part of a third whose floor it shares; then the
/// question is asked again. Of two doors between the same rooms whose jambs meet, one that was
/// not used is none. Free space goes to the room from
/// which it is reached; openings into what was not entered end it.
/// @param building_from_robot the mission's path, in its order; not empty
[[nodiscard]] RoomSegmentation segment_rooms(const BuildingGrid& grid,
                                             const std::vector<Pose2>& building_from_robot,
                                             const SegmentOptions& options);

/// The openings that the above asks about: doors, and what is too wide for them.
[[nodiscard]] std::vector<Doorway> openings_between_rooms(const BuildingGrid& grid,
                                                          const SegmentOptions& options);

/// The same rooms where it is known which openings may part them.
[[nodiscard]] RoomSegmentation segment_rooms(const BuildingGrid& grid,
                                             const std::vector<Doorway>& openings,
                                             const std::vector<Pose2>& building_from_robot,
                                             const SegmentOptions& options);

}  // namespace roomatlas
