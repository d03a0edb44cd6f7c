// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "roomatlas/graph/doors.hpp"
#include "roomatlas/graph/segment_rooms.hpp"
#include "roomatlas/pipeline/pipeline.hpp"

namespace roomatlas {

/// The rooms of a mission, from all that it saw.
struct MappedBuilding {
  std::map<AsrId, RoomId> room_of_asr;  ///< the room in which most of its path lies
  std::vector<BuildingDoor> doors;
  std::vector<PlacedOutline> outlines;    ///< one a room
  std::vector<Polygon> furniture;         ///< what stands free in a room
  SensorKind sensor = SensorKind::laser;  ///< sonar where there were both
};

/// True when every ASR has a path that was found in a map, and readings were kept: then the mission
/// can be mapped as a whole.
[[nodiscard]] bool can_map_building(const AsrSource& source, const std::vector<Asr>& asrs);

/// All readings in one map, where the correction puts them; rooms, doors and outlines from it.
/// Readings are loaded for one ASR at a time.
[[nodiscard]] MappedBuilding map_building(const AsrSource& source, const Placement& placement,
                                          const RobotFootprint& footprint,
                                          const AssembleOptions& options, const Progress& progress);

}  // namespace roomatlas
