// SPDX-License-Identifier: GPL-3.0-or-later
// The poses of all visits of joined missions, by least squares.
#pragma once

#include <vector>

#include "roomatlas/join/join_missions.hpp"

namespace roomatlas {

/// Moves the visits of some missions so that their own corrections and the matches between them
/// agree best; the first visit of the first stays. Matches that contradict the others get that
/// verdict.
/// @param missions of one component
/// @param placement where their visits are so far; those are moved
/// @param closures between them
void solve_joint(const std::vector<const MissionMap*>& missions, const JoinOptions& options,
                 Placement& placement, std::vector<Closure>& closures);

}  // namespace roomatlas
