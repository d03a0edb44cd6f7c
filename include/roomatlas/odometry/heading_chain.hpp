// SPDX-License-Identifier: GPL-3.0-or-later
// The one hidden Markov chain of the heading. Who builds it says what was seen and how odometry
// drifts: the walls that sonars heard (`src/sonar/sighting_chain.hpp`), or the walls of whole rooms
// (`src/correct/asr_headings.hpp`).
#pragma once

#include <cstddef>
#include <vector>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

/// The states of a node of the chain: what has to be added to odometry's heading there, modulo 90
/// degrees, and which of the building's directions the walls around follow.
struct HeadingStates {
  std::size_t corrections = 0;  ///< steps in which [0, 90) degrees are cut: more cost time, fewer
                                ///< blur the heading
  std::size_t directions = 1;   ///< of the building, at least 1

  [[nodiscard]] std::size_t size() const { return corrections * directions; }
  [[nodiscard]] constexpr double step_rad() const {
    return kPi / 2.0 / static_cast<double>(corrections);
  }
};

/// One number, at least 0, for each state: the directions one after the other, in each the
/// corrections from 0 to 90 degrees.
using HeadingBelief = std::vector<double>;

/// A way in which odometry's heading may have drifted into a node.
struct HeadingMove {
  int steps = 0;       ///< of the correction, in (-corrections, corrections)
  double share = 0.0;  ///< of the belief that moves so, [0, 1]
};

/// All ways into a node. They sum to 1 and are as likely to the left as to the right: the backward
/// pass uses them, too. Their order is that in which they are added up.
using HeadingDrift = std::vector<HeadingMove>;

/// Where the backward pass makes its message sum to 1, so that it neither grows nor vanishes. The
/// posterior is the same but for rounding: each user keeps its own, and its results to the last
/// bit.
enum class MessageScaling { after_drift, after_evidence };

/// The chain as it was measured.
struct HeadingChain {
  HeadingStates states;
  std::vector<HeadingBelief> evidence;  ///< likelihood of what was seen, by node and state, above
                                        ///< 0; empty where nothing was seen
  double log_scale = 0.0;  ///< natural logarithm of what all evidence was divided by, so that it is
                           ///< neither too large nor too small for a number
  std::vector<HeadingDrift> drift;  ///< into each node; empty: odometry does not lead there
                                    ///< from the node before, and the chain begins anew
  double switch_share = 0.0;  ///< of the belief at each node that goes over to the building's other
                              ///< directions, [0, 1)
  MessageScaling scaling = MessageScaling::after_drift;
};

/// What a chain says.
struct HeadingPosterior {
  std::vector<HeadingBelief> beliefs;  ///< by node, given all evidence; in proportion, not to 1
  double log_evidence = 0.0;           ///< natural logarithm of the likelihood of all that was seen
};

/// Forward pass alone (Rabiner 1989, section III A). @return the log evidence; 0 without nodes
[[nodiscard]] double log_evidence(const HeadingChain& chain);

/// Forward and backward pass (Rabiner 1989, section III B): exact, but for rounding. Empty without
/// nodes. Cost: nodes times states times moves.
[[nodiscard]] HeadingPosterior posterior(const HeadingChain& chain);

/// Makes a belief sum to 1; its sum must be above 0. @return what it summed to
double normalise(HeadingBelief& belief);

}  // namespace roomatlas
