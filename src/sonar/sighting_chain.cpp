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

/// What all walls at a node say. Of hundreds the product is no number any more, so that logarithms
/// of products of a few are summed.
/// @param log_scale receives the logarithm of what the evidence was divided by
HeadingBelief evidence_of(const std::vector<const WallSighting*>& walls,
                          std::span<const double> directions_rad, const HeadingStates& states,
                          const SightingChainOptions& options, double& log_scale) {
  constexpr std::size_t kFew = 64;
  constexpr double kLeast =
      1e-100;  // of the likeliest: nodes that contradict each other leave some
  HeadingBelief product(states.size(), 1.0);
  HeadingBelief logs(walls.size() > kFew ? states.size() : 0, 0.0);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    weigh(product, *walls[i], directions_rad, states, options);
    if (logs.empty() || ((i + 1) % kFew != 0 && i + 1 < walls.size())) continue;
    for (std::size_t s = 0; s < logs.size(); ++s) logs[s] += std::log(product[s]);
    product.assign(states.size(), 1.0);
  }
  if (!logs.empty()) {
    const double most = *std::max_element(logs.begin(), logs.end());
    for (std::size_t s = 0; s < logs.size(); ++s) product[s] = std::exp(logs[s] - most);
    log_scale += most;
  }
  const double least = kLeast * *std::max_element(product.begin(), product.end());
  for (double& value : product) value = std::max(value, least);
  return product;
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
  std::vector<std::vector<const WallSighting*>> walls_at(nodes.size());
  for (const WallSighting& wall : sightings) walls_at[wall.node].push_back(&wall);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (walls_at[k].empty()) continue;
    chain.evidence[k] =
        evidence_of(walls_at[k], directions_rad, chain.states, options, chain.log_scale);
  }
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    chain.drift[k] = drift_between(nodes[k - 1], nodes[k], chain.states, options);
  }
  return chain;
}

}  // namespace roomatlas
