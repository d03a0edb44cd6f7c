// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/floor_plan.hpp"

#include <cstdint>
#include <map>

namespace roomatlas {

/// How the graph of rooms and doors differs from the true one. Vertices are rooms, and each door
/// between two different rooms is an edge: two doors between the same rooms are two edges. Doors
/// to the outside, or to a side that is not known, are no edges.
struct PlanGraphErrors {
  std::int64_t edges = 0;
  std::int64_t true_edges = 0;
  bool isomorphic = false;   ///< the graphs are equal under some renaming of the rooms
  bool as_matched = false;   ///< they are equal under the matching of the rooms by their place
  std::int64_t missing = 0;  ///< true edges that no found edge stands for
  std::int64_t extra = 0;    ///< found edges at a room without a match, or one door too many
  std::int64_t wrong = 0;    ///< found edges between matched rooms that no true door joins

  [[nodiscard]] std::int64_t edits() const { return missing + extra + wrong; }
};

/// Compares the graphs. Isomorphism is decided by VF2 (Cordella et al., "A (sub)graph isomorphism
/// algorithm for matching large graphs", 2004) among rooms that refinement of colours cannot tell
/// apart.
/// @param true_room_of the true room of each matched room, one to one
[[nodiscard]] PlanGraphErrors plan_graph_errors(const FloorPlan& plan, const FloorPlan& truth,
                                                const std::map<RoomId, RoomId>& true_room_of);

}  // namespace roomatlas
