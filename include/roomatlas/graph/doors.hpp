// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/graph/room_graph.hpp"

namespace roomatlas {

/// One doorway of the building: all crossings of it, averaged.
struct BuildingDoor {
  Pose2 building_from_pivot;  ///< theta leads from `room_a` to `room_b`
  double width_m = 0.0;       ///< median of the crossings
  RoomId room_a = 0;          ///< the room that the first crossing left
  RoomId room_b = 0;
  std::vector<AsrId> crossings;  ///< the ASRs that begin at it
};

/// The doorways between different rooms, each once, in the order of their first crossing.
/// Crossings that the graph recognises as the same doorway are one; so are those between the same
/// two rooms that lie within 0.8 m.
[[nodiscard]] std::vector<BuildingDoor> doors_of(const std::vector<Asr>& asrs,
                                                 const RoomGraph& graph, const Placement& placement,
                                                 const std::map<AsrId, RoomId>& room_of_asr);

/// The jambs of a door, left and right of its direction.
[[nodiscard]] Segment2 jambs_of(const BuildingDoor& door);

}  // namespace roomatlas
