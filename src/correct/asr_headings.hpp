// SPDX-License-Identifier: GPL-3.0-or-later
// The heading's chain (roomatlas/odometry/heading_chain.hpp) of a mission of ASRs: a node each, and
// the direction of its walls as evidence.
#pragma once

#include <vector>

#include "models.hpp"

namespace roomatlas {

/// What the walls of all ASRs say of odometry's heading.
struct AsrHeadings {
  std::vector<double> correction_rad;  ///< to be added to odometry's heading of each ASR, unwrapped
                                       ///< along the mission; 0 where a component starts
  double log_evidence = 0.0;           ///< of the walls' directions, given the habits
};

/// The posterior's circular mean of a chain with a state a degree, modulo 90 degrees. Where
/// odometry does not lead from an ASR to the next, the chain begins anew. Without any walls all
/// corrections are 0. A wall direction may be wrong (30 % uniform).
/// @param habits to be taken out of the driven edges before
[[nodiscard]] AsrHeadings asr_headings(const Measurements& measurements,
                                       const OdometryHabits& habits, const CorrectOptions& options);

/// Bias and gain of turns with the greatest evidence of the chain, searched over 3.7 degrees a
/// metre and 7 % of the turns to both sides, with a weak prior at none. None for fewer than eight
/// rectilinear ASRs.
[[nodiscard]] EstimatedHabits estimate_habits(const Measurements& measurements,
                                              const CorrectOptions& options);

/// Takes habits of the heading out of the driven edges. An ASR whose path was bent by a bias is
/// placed by its walls, whose direction it turned by half of what it turned the end of the path.
void take_out_habits(Measurements& measurements, const OdometryHabits& habits);

}  // namespace roomatlas
