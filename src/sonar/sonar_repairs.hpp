// SPDX-License-Identifier: GPL-3.0-or-later
// Other ways to solve what was kept: other turns of the heading, other tolerances of the batch.
#pragma once

#include "sonar_attempt.hpp"

namespace roomatlas {

/// Tries the other ways that the heading may have gone, the likeliest first, and keeps what brings
/// more walls together. Adds each try to the result's variants.
/// @param others receives the attempts that are not kept
void repair_slips(const SonarMission& mission, Idea& idea, std::vector<Attempt>& others,
                  SonarTrajectory& result);

/// Solves the best heading again from other tolerances: a large one brings together what drifted
/// far apart, a small one does not mistake the other side of a corridor for this one. Then extracts
/// the walls anew at the poses found, and solves once more, as long as that brings more together.
void refine(const SonarMission& mission, Idea& idea, SonarTrajectory& result);

}  // namespace roomatlas
