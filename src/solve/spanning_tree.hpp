// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linearise.hpp"

namespace roomatlas {

/// Edges at each slot.
struct Incidence {
  std::vector<std::int32_t> begin;  ///< into `edges`, and the end
  std::vector<std::int32_t> edges;
};

[[nodiscard]] Incidence incidence_of(const SolverGraph& graph);

/// How each slot is reached from the fixed node of its component.
struct SpanningTree {
  std::vector<std::int32_t> order;  ///< slots, each after the one that it is reached from
  std::vector<std::int32_t> via;    ///< edge into each slot; -1 for a fixed one
};

/// Breadth first, so that few edges lie between a slot and its fixed node.
/// @param costly one an edge, or empty: edges that are used only where no others lead on
/// @param weights edges of weight 0 are not used at all; slots behind them are left out
[[nodiscard]] SpanningTree spanning_tree(const SolverGraph& graph, const Incidence& incidence,
                                         std::span<const std::uint8_t> costly,
                                         std::span<const double> weights);

/// Poses along the tree; fixed nodes, and slots that are not in the tree, at the origin.
[[nodiscard]] SlotPoses poses_along(const SolverGraph& graph, const SpanningTree& tree);

/// Whether, around each loop that an edge closes over the tree, heading errors add up to less than
/// half a turn. If not, the state may be a local minimum that has wound a loop once too often.
[[nodiscard]] bool winds_right(const SolverGraph& graph, const SpanningTree& tree,
                               const SlotPoses& state, std::span<const double> weights);

/// Headings from the linear problem that is left when each loop over the tree winds such that
/// its closing error is less than half a turn (Carlone et al. 2011).
/// @return a state with all positions zero, or an empty one where the system is singular
[[nodiscard]] SlotPoses headings_by_winding(const SolverGraph& graph, const SpanningTree& tree,
                                            std::span<const double> weights);

}  // namespace roomatlas
