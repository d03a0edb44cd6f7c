// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/correct/correction.hpp"
#include "roomatlas/graph/room_graph.hpp"

namespace roomatlas {

/// A mission's paths and walls, where odometry alone and where the correction puts them.
struct PlacedMission {
  Trajectory odometry;                 ///< as in the log, one pose a reading
  Trajectory corrected;                ///< building metres, parallel to `odometry`
  Polyline path_before;                ///< odometry's path, building metres
  std::vector<Polyline> walls_before;  ///< building metres
  std::vector<Polyline> walls_after;
};
[[nodiscard]] PlacedMission place(const AsrSource& source, const Correction& correction);

/// The room graph as the correction left it: what was driven, and the doorways it recognised.
[[nodiscard]] RoomGraph graph_of(const AsrSource& source, const Correction& correction);

}  // namespace roomatlas
