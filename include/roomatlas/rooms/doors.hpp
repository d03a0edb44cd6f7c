// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/graph/room_graph.hpp"
#include "roomatlas/plan/door.hpp"

namespace roomatlas {

/// The doorways between different rooms, each once, in the order of their first crossing.
/// Crossings that the graph recognises as the same doorway are one; so are those between the same
/// two rooms that lie within 0.8 m. Pivots are means of the crossings, widths their median.
[[nodiscard]] std::vector<Door> doors_of(const std::vector<Asr>& asrs, const RoomGraph& graph,
                                         const Placement& placement,
                                         const std::map<AsrId, RoomId>& room_of_asr);

}  // namespace roomatlas
