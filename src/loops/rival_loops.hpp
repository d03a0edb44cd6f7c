// SPDX-License-Identifier: GPL-3.0-or-later
// Loops closed in one way or another, and whether the readings can tell which is true.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "placed_graph.hpp"
#include "roomatlas/loops/close_loops.hpp"

namespace roomatlas {

/// Where rooms lie, and what was matched there.
struct LoopsState {
  PlacedGraph placed;
  std::vector<Closure> closures;
  std::vector<Pair> pairs;      ///< parallel to `closures`
  std::set<AsrId> lost_before;  ///< as in `ClosedLoops`

  /// What speaks for the places of all rooms together.
  [[nodiscard]] double total_score() const;
  /// Of the points that can tell, of all pairs, [0, 1].
  [[nodiscard]] double contradicted_share() const;
};

/// The best of some states that put rooms elsewhere than the kept one does, where the matches of
/// these rooms speak for it nearly as much, and chance alone may have preferred the one kept.
struct RivalLoops {
  std::size_t which = 0;  ///< of the states
  SecondLoops second;
};

/// @param asrs in the order of the graph's nodes
/// @param cell_m between points of a room's map
[[nodiscard]] std::optional<RivalLoops> rival_of(const LoopsState& kept,
                                                 const std::vector<LoopsState>& states,
                                                 std::size_t asrs, double cell_m);

}  // namespace roomatlas
