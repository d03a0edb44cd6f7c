// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "roomatlas/asr/map_room.hpp"
#include "roomatlas/asr/store.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/plan/door.hpp"
#include "roomatlas/plan/placed_outline.hpp"
#include "roomatlas/rooms/segment_rooms.hpp"

namespace roomatlas {

/// The rooms of a mission, from all that it saw.
struct MappedBuilding {
  std::map<AsrId, RoomId> room_of_asr;  ///< the room in which most of its path lies
  std::vector<Door> doors;              ///< between two rooms, in the order of their first crossing
  std::vector<PlacedOutline> outlines;  ///< one a room; of ASRs where rooms are made of these
  std::vector<Polygon> furniture;       ///< what stands free in a room
  SensorKind sensor = SensorKind::laser;  ///< sonar where there were both
};

/// How a whole mission's readings become rooms.
struct MapBuildingOptions {
  RoomMapOptions map;      ///< of sweeps and outlines, as for a single room
  SegmentOptions segment;  ///< of rooms and doors
};

/// All readings in one map, where the correction puts them; rooms, doors and outlines from it.
/// Readings are loaded for one ASR at a time.
/// @throws InputError for an ASR without its readings
[[nodiscard]] MappedBuilding map_building(const AsrSource& source, const Placement& placement,
                                          const RobotFootprint& footprint,
                                          const MapBuildingOptions& options,
                                          const Progress& progress);

}  // namespace roomatlas
