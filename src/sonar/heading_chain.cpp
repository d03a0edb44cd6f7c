// SPDX-License-Identifier: GPL-3.0-or-later
#include "heading_chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "heading_beliefs.hpp"

namespace roomatlas {
namespace {

/// Of the correction, whatever the direction.
Belief marginal(const Belief& belief, const BeliefShape& shape) {
  Belief result(shape.corrections, 0.0);
  for (std::size_t i = 0; i < belief.size(); ++i) result[i % shape.corrections] += belief[i];
  return result;
}

struct Moments {
  double mean_rad = 0.0;
  double sigma_rad = 0.0;
};

/// Mean and standard deviation within 45 degrees of the mode.
Moments moments_about_mode(const Belief& belief, const BeliefShape& shape) {
  const auto mode = std::max_element(belief.begin(), belief.end()) - belief.begin();
  const auto count = static_cast<std::ptrdiff_t>(shape.corrections);
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
  return {(static_cast<double>(mode) + mean) * shape.step_rad(),
          std::sqrt(variance) * shape.step_rad()};
}

}  // namespace

double heading_evidence(std::span<const HeadingNode> nodes, std::span<const WallSighting> sightings,
                        std::span<const double> directions_rad,
                        const HeadingChainOptions& options) {
  return filter(heading_model(nodes, sightings, directions_rad, options), nullptr);
}

HeadingChain smooth_heading(std::span<const HeadingNode> nodes,
                            std::span<const WallSighting> sightings,
                            std::span<const double> directions_rad,
                            const HeadingChainOptions& options) {
  const HeadingModel model = heading_model(nodes, sightings, directions_rad, options);
  std::vector<Belief> beliefs;
  HeadingChain result;
  result.log_evidence = filter(model, &beliefs);
  result.correction_rad.resize(nodes.size());
  result.sigma_rad.resize(nodes.size());
  Belief later(model.shape.size(), 1.0);  // what the nodes behind say of this one
  Belief scratch;
  for (std::size_t k = nodes.size(); k-- > 0;) {
    Belief belief = beliefs[k];
    multiply(belief, later);
    const Moments moments = moments_about_mode(marginal(belief, model.shape), model.shape);
    result.correction_rad[k] = moments.mean_rad;
    result.sigma_rad[k] = moments.sigma_rad;
    if (k == 0) break;
    multiply(later, model.walls[k]);
    spread(later, model.kernels[k], model.shape, model.switch_share, scratch);
    normalise(later);
  }
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const double step = result.correction_rad[k] - result.correction_rad[k - 1];
    result.correction_rad[k] = result.correction_rad[k - 1] + wrap_quarter(step);
  }
  return result;
}

}  // namespace roomatlas
