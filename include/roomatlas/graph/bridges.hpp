// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "roomatlas/graph/room_graph.hpp"

namespace roomatlas {

/// An edge without which its component falls apart: nothing else holds one side to the other.
struct Bridge {
  std::size_t edge = 0;    ///< place among `RoomGraph::edges`
  std::size_t behind = 0;  ///< visits on its smaller side
};

/// The bridges of a room graph, in the order of its edges. Two edges between the same visits are
/// none.
[[nodiscard]] std::vector<Bridge> bridges_of(const RoomGraph& graph);

/// The visits on a bridge's smaller side; of two alike that of the later visit.
[[nodiscard]] std::set<AsrId> visits_behind(const RoomGraph& graph, const Bridge& bridge);

}  // namespace roomatlas
