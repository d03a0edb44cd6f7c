// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "roomatlas/graph/room_graph.hpp"

namespace roomatlas {

struct RoomOptions {
  double min_overlap_share = 0.4;   ///< outlines that share this much of the smaller one are one
                                    ///< room; smaller joins rooms whose placement is off
  double min_path_share = 0.5;      ///< a path that runs this much of its length inside another
                                    ///< outline is in the same room
  double wall_beside_door_m = 0.6;  ///< a doorway that separates rooms has wall beside a jamb over
                                    ///< this length ...
  double min_wall_share = 0.45;     ///< ... of which this share has been seen
};

/// Decides which ASRs are the same room: those joined by open passages, those on the same side of
/// a doorway seen twice, those whose outlines overlap or whose path runs in the other's outline,
/// and those on the two sides of an opening that has no wall beside it (a gap between furniture).
/// @returns the room of each ASR; rooms are numbered 1, 2, 3 ... by their first ASR
[[nodiscard]] std::map<AsrId, RoomId> assign_rooms(const std::vector<Asr>& asrs,
                                                   const RoomGraph& graph,
                                                   const Placement& placement,
                                                   const RoomOptions& options);

/// The share of the smaller outline's area that both cover, [0, 1]; 0 when either is empty.
/// Sampled on a lattice of 0.2 m.
[[nodiscard]] double overlap_share(const Polygon& first, const Polygon& second);

}  // namespace roomatlas
