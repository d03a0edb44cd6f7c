// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/door.hpp"
#include "roomatlas/plan/floor_plan.hpp"
#include "roomatlas/plan/placed_outline.hpp"

namespace roomatlas {

/// The rooms of a building, before they are merged into a plan; building metres.
struct MappedBuilding {
  std::map<AsrId, RoomId> room_of_asr;  ///< the room in which most of its path lies
  std::vector<Door> doors;              ///< between two rooms, in the order of their first crossing
  std::vector<PlacedOutline> outlines;  ///< one a room where it is drafted; else one an ASR
  SensorKind sensor = SensorKind::laser;  ///< sonar where there were both
  std::map<RoomId, std::string> names;    ///< that somebody gave, and kinds of rooms likewise
  std::map<RoomId, RoomKind> kinds;

  // Of a drafted building alone:
  bool is_drafted = false;                       ///< outlines are walls, not what was seen free
  std::vector<PlacedOutline> measured_outlines;  ///< the same rooms as far as they were seen free
  std::vector<Polygon> wall_bodies;              ///< between two faces of a wall that were seen
  std::vector<PlanFurniture> furniture;
  std::vector<PlanEdge> edges;
};

}  // namespace roomatlas
