// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/heading_chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace roomatlas {
namespace {

void multiply(HeadingBelief& belief, const HeadingBelief& by) {
  for (std::size_t s = 0; s < by.size(); ++s) belief[s] *= by[s];
}

/// What is believed where nothing is known.
HeadingBelief uniform(const HeadingStates& states) {
  HeadingBelief belief(states.size(), 1.0);
  normalise(belief);
  return belief;
}

/// The correction drifts: a circular convolution in each direction of the building.
/// @param scratch any; kept by the caller so that it is allocated once
void drift_apart(HeadingBelief& belief, const HeadingDrift& drift, const HeadingStates& states,
                 HeadingBelief& scratch) {
  int farthest = 0;
  for (const HeadingMove& move : drift) farthest = std::max(farthest, std::abs(move.steps));
  const std::size_t count = states.corrections;
  for (std::size_t d = 0; d < states.directions; ++d) {
    double* const part = belief.data() + d * count;
    // once round and a margin at both ends, so that no move has to wrap
    scratch.assign(part + count - farthest, part + count);
    scratch.insert(scratch.end(), part, part + count);
    scratch.insert(scratch.end(), part, part + farthest);
    std::fill(part, part + count, 0.0);
    for (const HeadingMove& move : drift) {
      const double share = move.share;
      const double* const from = scratch.data() + (farthest - move.steps);
      for (std::size_t s = 0; s < count; ++s) part[s] += share * from[s];
    }
  }
}

/// Rarely, the walls around follow another direction from here on.
void switch_directions(HeadingBelief& belief, const HeadingChain& chain) {
  const HeadingStates& states = chain.states;
  if (states.directions < 2) return;
  const auto others = static_cast<double>(states.directions - 1);
  for (std::size_t s = 0; s < states.corrections; ++s) {
    double sum = 0.0;
    for (std::size_t d = 0; d < states.directions; ++d) sum += belief[d * states.corrections + s];
    for (std::size_t d = 0; d < states.directions; ++d) {
      double& value = belief[d * states.corrections + s];
      value = (1.0 - chain.switch_share) * value + chain.switch_share / others * (sum - value);
    }
  }
}

/// The belief on the other side of the way into a node, whichever side it is on.
void carry(HeadingBelief& belief, const HeadingChain& chain, std::size_t node,
           HeadingBelief& scratch) {
  drift_apart(belief, chain.drift[node], chain.states, scratch);
  switch_directions(belief, chain);
}

/// Forward pass. @param keep receives the belief at each node from what came before, where given
double filter(const HeadingChain& chain, std::vector<HeadingBelief>* keep) {
  HeadingBelief scratch;
  HeadingBelief belief;
  double log_evidence = chain.log_scale;
  for (std::size_t k = 0; k < chain.evidence.size(); ++k) {
    if (k == 0 || chain.drift[k].empty()) {
      belief = uniform(chain.states);
    } else {
      carry(belief, chain, k, scratch);
    }
    multiply(belief, chain.evidence[k]);
    log_evidence += std::log(normalise(belief));
    if (keep != nullptr) keep->push_back(belief);
  }
  return log_evidence;
}

}  // namespace

double normalise(HeadingBelief& belief) {
  double sum = 0.0;
  for (const double value : belief) sum += value;
  for (double& value : belief) value /= sum;
  return sum;
}

double log_evidence(const HeadingChain& chain) { return filter(chain, nullptr); }

HeadingPosterior posterior(const HeadingChain& chain) {
  HeadingPosterior result;
  result.log_evidence = filter(chain, &result.beliefs);
  const bool scales_first = chain.scaling == MessageScaling::after_evidence;
  const HeadingBelief nothing =
      scales_first ? uniform(chain.states) : HeadingBelief(chain.states.size(), 1.0);
  HeadingBelief later = nothing;  // what the nodes behind say of this one
  HeadingBelief scratch;
  for (std::size_t k = result.beliefs.size(); k-- > 0;) {
    multiply(result.beliefs[k], later);
    if (k == 0) break;
    if (chain.drift[k].empty()) {
      later = nothing;
      continue;
    }
    multiply(later, chain.evidence[k]);
    if (scales_first) normalise(later);
    carry(later, chain, k, scratch);
    if (!scales_first) normalise(later);
  }
  return result;
}

}  // namespace roomatlas
