// SPDX-License-Identifier: GPL-3.0-or-later
// The hidden Markov model behind heading_chain.hpp: its states, what drift and walls make of a
// belief about them, and the forward pass.
#pragma once

#include <cstddef>
#include <vector>

#include "heading_chain.hpp"
#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

/// One number for each state: directions of the building one after the other, in each the
/// corrections from 0 to 90 degrees.
using Belief = std::vector<double>;

struct BeliefShape {
  std::size_t corrections = 0;
  std::size_t directions = 0;
  [[nodiscard]] std::size_t size() const { return corrections * directions; }
  [[nodiscard]] double step_rad() const { return kPi / 2.0 / static_cast<double>(corrections); }
};

/// Makes a belief sum to 1. @return what it summed to
double normalise(Belief& belief);

/// The belief after drift: of the correction by a circular convolution, of the direction by rare
/// switches. Both are as likely one way as the other, so that the backward pass uses it too.
/// @param kernel weights of the steps -width to width of the correction
void spread(Belief& belief, const std::vector<double>& kernel, const BeliefShape& shape,
            double switch_share, Belief& scratch);

void multiply(Belief& belief, const Belief& by);

/// The chain with what each node's walls say already multiplied out.
struct HeadingModel {
  BeliefShape shape;
  std::vector<Belief> walls;                 ///< by node; empty where no wall was seen
  std::vector<std::vector<double>> kernels;  ///< into each node
  double switch_share = 0.0;
};

[[nodiscard]] HeadingModel heading_model(std::span<const HeadingNode> nodes,
                                         std::span<const WallSighting> sightings,
                                         std::span<const double> directions_rad,
                                         const HeadingChainOptions& options);

/// Forward pass. @param keep receives the belief at each node, where given
/// @return the log evidence
double filter(const HeadingModel& model, std::vector<Belief>* keep);

}  // namespace roomatlas
