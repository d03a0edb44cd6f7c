// SPDX-License-Identifier: GPL-3.0-or-later
// Measured headings: which quarter turn each means, and how a component must turn to follow them.
#pragma once

#include "linearise.hpp"

namespace roomatlas {

/// Gives each heading that is measured but for quarter turns the value nearest to the state.
void settle_quarters(const PoseGraph& poses, const SlotPoses& state, SolverGraph& graph);

/// Turns each component that has headings about its fixed node so that they fit on average, before
/// quarter turns are settled: by its full headings or, where it has none, by a quarter at most.
void turn_to_quarters(const PoseGraph& poses, const SolverGraph& graph, SlotPoses& state);

/// The same with settled quarter turns. Where no heading is measured nothing changes.
void turn_to_headings(const SolverGraph& graph, SlotPoses& state);

}  // namespace roomatlas
