// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/asr/map_room.hpp"
#include "roomatlas/asr/store.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/graph/room_graph.hpp"
#include "roomatlas/rooms/assign_rooms.hpp"
#include "roomatlas/rooms/mapped_building.hpp"

namespace roomatlas {

struct OutlineRoomOptions {
  RoomOptions rooms;
  RoomMapOptions map;     ///< for mapping rooms again once all doors are known
  bool map_again = true;  ///< cut outlines at doors that only later visits found
};

/// Rooms where the readings were not kept, or do not lie where the robot was: from the ASRs'
/// outlines, as the paper has it. Outlines are cut at all doors of their room, those that only
/// later visits found too.
/// Readings are loaded for one ASR at a time.
[[nodiscard]] MappedBuilding rooms_by_outlines(const AsrSource& source, const RoomGraph& graph,
                                               const Placement& placement,
                                               const RobotFootprint& footprint,
                                               const OutlineRoomOptions& options,
                                               const Progress& progress);

}  // namespace roomatlas
