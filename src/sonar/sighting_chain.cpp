// SPDX-License-Identifier: GPL-3.0-or-later
#include "sighting_chain.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kDriftSigmas = 4.0;     // to each side; what lies beyond is a jump
constexpr int kWidestPart = 3;           // and no more than this part of the states: drift to the
                                         // left and to the right must not meet
constexpr double kSightingSigmas = 5.0;  // farther off, a wall follows another direction or none

HeadingDrift drift_between(const HeadingNode& from, const HeadingNode& to,
                           const HeadingStates& states, const SightingChainOptions& options) {
  const double sigma_rad = std::sqrt(sum_of_squares(
      options.odometry.heading, to.path_m - from.path_m, to.turned_rad - from.turned_rad));
  const double sigma = sigma_rad / states.step_rad();
  const int widest = static_cast<int>(states.corrections) / kWidestPart;
  const int width = std::min(widest, static_cast<int>(std::ceil(kDriftSigmas * sigma)) + 1);
  HeadingDrift drift;
  double sum = 0.0;
  for (int steps = width; steps >= -width; --steps) {
    const double share = std::exp(-steps * steps / (2.0 * sigma * sigma)) + options.jump_share;
    drift.push_back({steps, share});
    sum += share;
  }
  for (HeadingMove& move : drift) move.share /= sum;
  return drift;
}

/// Multiplies a node's evidence by what one wall says: a mixture of walls that follow a direction
/// of the building and of walls that lie anyhow, relative to the latter.
void weigh(HeadingBelief& evidence, const WallSighting& wall,
           std::span<const double> directions_rad, const HeadingStates& states,
           const SightingChainOptions& options) {
  const double sigma_rad =
      std::hypot(options.segment_sigma_rad, options.end_sigma_m / wall.length_m);
  const double peak = options.trust * (kPi / 2.0) / (sigma_rad * std::sqrt(2.0 * kPi));
  const double weight = std::min(1.0, wall.length_m / options.full_weight_m);
  const double elsewhere = std::pow(1.0 - options.trust, weight);
  for (std::size_t d = 0; d < states.directions; ++d) {
    for (std::size_t s = 0; s < states.corrections; ++s) {
      double& at = evidence[d * states.corrections + s];
      const double off = wrap_quarter(wall.direction_rad - directions_rad[d] +
                                      static_cast<double>(s) * states.step_rad());
      const double sigmas = off / sigma_rad;
      if (std::abs(sigmas) > kSightingSigmas) {
        at *= elsewhere;
        continue;
      }
      const double likelihood = 1.0 - options.trust + peak * std::exp(-sigmas * sigmas / 2.0);
      at *= std::pow(likelihood, weight);
    }
  }
}

}  // namespace

HeadingChain sighting_chain(std::span<const HeadingNode> nodes,
                            std::span<const WallSighting> sightings,
                            std::span<const double> directions_rad,
                            const SightingChainOptions& options) {
  HeadingChain chain;
  chain.states = {static_cast<std::size_t>(options.states), directions_rad.size()};
  chain.switch_share = options.switch_share;
  chain.evidence.resize(nodes.size());
  chain.drift.resize(nodes.size());
  for (const WallSighting& wall : sightings) {
    HeadingBelief& at = chain.evidence[wall.node];
    if (at.empty()) at.assign(chain.states.size(), 1.0);
    weigh(at, wall, directions_rad, chain.states, options);
  }
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    chain.drift[k] = drift_between(nodes[k - 1], nodes[k], chain.states, options);
  }
  return chain;
}

}  // namespace roomatlas
