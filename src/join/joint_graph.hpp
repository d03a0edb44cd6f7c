// SPDX-License-Identifier: GPL-3.0-or-later
// The poses of all visits of joined missions, by least squares.
#pragma once

#include <span>
#include <vector>

#include "roomatlas/join/join_missions.hpp"

namespace roomatlas {

/// Moves the visits of some missions so that their own corrections and the matches between them
/// agree best; the first visit of the first stays. Matches that contradict the others get that
/// verdict.
/// @param missions of one component
/// @param placement where their visits are so far; those are moved
/// @param closures between them
/// @param loss_width times `robust_sigmas`: how far off a match may be and still pull
void solve_joint(const std::vector<const MissionMap*>& missions, const JoinOptions& options,
                 Placement& placement, std::vector<Closure>& closures, double loss_width = 1.0);

/// Moves the visits of one mission alone, against what is joined already, which stays where it is:
/// costs what the mission costs. Of its matches those that contradict the others get that verdict.
/// @param placement of all visits; those of the mission are moved
/// @param closures of the mission with others
/// @returns false where any match contradicts, so that what is joined may have to give way
[[nodiscard]] bool solve_alone(const MissionMap& mission, const JoinOptions& options,
                               Placement& placement, std::span<Closure> closures);

}  // namespace roomatlas
