// SPDX-License-Identifier: GPL-3.0-or-later
#include "mission_heading.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace roomatlas {
namespace {

/// Of the correction, whatever the direction.
HeadingBelief marginal(const HeadingBelief& belief, const HeadingStates& states) {
  HeadingBelief result(states.corrections, 0.0);
  for (std::size_t i = 0; i < belief.size(); ++i) result[i % states.corrections] += belief[i];
  return result;
}

struct Moments {
  double mean_rad = 0.0;
  double sigma_rad = 0.0;
};

/// Mean and standard deviation within 45 degrees of the mode.
Moments moments_about_mode(const HeadingBelief& belief, const HeadingStates& states) {
  const auto mode = std::max_element(belief.begin(), belief.end()) - belief.begin();
  const auto count = static_cast<std::ptrdiff_t>(states.corrections);
  double sum = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (std::ptrdiff_t step = -count / 2; step < count / 2; ++step) {
    const double weight = belief[static_cast<std::size_t>((mode + step + count) % count)];
    const double at = static_cast<double>(step);
    sum += weight;
    first += weight * at;
    second += weight * at * at;
  }
  const double mean = first / sum;
  const double variance = std::max(0.0, second / sum - mean * mean);
  return {(static_cast<double>(mode) + mean) * states.step_rad(),
          std::sqrt(variance) * states.step_rad()};
}

}  // namespace

double heading_evidence(std::span<const HeadingNode> nodes, std::span<const WallSighting> sightings,
                        std::span<const double> directions_rad,
                        const SightingChainOptions& options) {
  return log_evidence(sighting_chain(nodes, sightings, directions_rad, options));
}

MissionHeading mission_heading(std::span<const HeadingNode> nodes,
                               std::span<const WallSighting> sightings,
                               std::span<const double> directions_rad,
                               const SightingChainOptions& options) {
  const HeadingChain chain = sighting_chain(nodes, sightings, directions_rad, options);
  const HeadingPosterior found = posterior(chain);
  MissionHeading result;
  result.log_evidence = found.log_evidence;
  for (const HeadingBelief& belief : found.beliefs) {
    const Moments moments = moments_about_mode(marginal(belief, chain.states), chain.states);
    result.sigma_rad.push_back(moments.sigma_rad);
    result.correction_rad.push_back(moments.mean_rad);
  }
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const double step = result.correction_rad[k] - result.correction_rad[k - 1];
    result.correction_rad[k] = result.correction_rad[k - 1] + wrap_quarter(step);
  }
  return result;
}

}  // namespace roomatlas
