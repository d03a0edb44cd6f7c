// SPDX-License-Identifier: GPL-3.0-or-later
#include "heading_chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/correct/wall_direction.hpp"

namespace roomatlas {
namespace {

/// One number for each state: directions of the building one after the other, in each the
/// corrections from 0 to 90 degrees.
using Belief = std::vector<double>;

struct Shape {
  std::size_t corrections = 0;
  std::size_t directions = 0;
  [[nodiscard]] std::size_t size() const { return corrections * directions; }
  [[nodiscard]] double step_rad() const { return kPi / 2.0 / static_cast<double>(corrections); }
};

double normalise(Belief& belief) {
  double sum = 0.0;
  for (const double value : belief) sum += value;
  for (double& value : belief) value /= sum;
  return sum;
}

/// Weights of the steps -width to width of the correction, which sum to 1.
std::vector<double> drift_kernel(const HeadingNode& from, const HeadingNode& to, const Shape& shape,
                                 const HeadingChainOptions& options) {
  const double by_turn = options.drift_per_turn * (to.turned_rad - from.turned_rad);
  const double by_way = options.drift_rad_per_sqrt_m;
  const double sigma_rad =
      std::sqrt(by_way * by_way * (to.path_m - from.path_m) + by_turn * by_turn +
                options.base_rad * options.base_rad);
  const double sigma = sigma_rad / shape.step_rad();
  const int widest = static_cast<int>(shape.corrections / 3);
  const int width = std::min(widest, static_cast<int>(std::ceil(4.0 * sigma)) + 1);
  std::vector<double> kernel;
  for (int step = -width; step <= width; ++step) {
    kernel.push_back(std::exp(-step * step / (2.0 * sigma * sigma)) + options.jump_share);
  }
  normalise(kernel);
  return kernel;
}

/// The belief after drift: of the correction by a circular convolution, of the direction by rare
/// switches. Both are as likely one way as the other, so that the backward pass uses it too.
void spread(Belief& belief, const std::vector<double>& kernel, const Shape& shape,
            double switch_share, Belief& scratch) {
  const std::size_t width = kernel.size() / 2;
  const std::size_t count = shape.corrections;
  scratch.resize(count + 2 * width);
  for (std::size_t d = 0; d < shape.directions; ++d) {
    double* const part = belief.data() + d * count;
    for (std::size_t i = 0; i < scratch.size(); ++i) {
      scratch[i] = part[(i + count - width) % count];
    }
    std::fill(part, part + count, 0.0);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const double weight = kernel[k];
      const double* const shifted = scratch.data() + k;
      for (std::size_t s = 0; s < count; ++s) part[s] += weight * shifted[s];
    }
  }
  if (shape.directions < 2) return;
  const double others = static_cast<double>(shape.directions - 1);
  for (std::size_t s = 0; s < count; ++s) {
    double sum = 0.0;
    for (std::size_t d = 0; d < shape.directions; ++d) sum += belief[d * count + s];
    for (std::size_t d = 0; d < shape.directions; ++d) {
      double& value = belief[d * count + s];
      value = (1.0 - switch_share) * value + switch_share / others * (sum - value);
    }
  }
}

/// Multiplies a belief by what one wall says of it.
void weigh(Belief& belief, const WallSighting& wall, std::span<const double> directions_rad,
           const Shape& shape, const HeadingChainOptions& options) {
  const double sigma_rad =
      std::hypot(options.segment_sigma_rad, options.end_sigma_m / wall.length_m);
  const double peak = options.trust * (kPi / 2.0) / (sigma_rad * std::sqrt(2.0 * kPi));
  const double weight = std::min(1.0, wall.length_m / options.full_weight_m);
  constexpr double kFarSigmas = 5.0;
  const double elsewhere = std::pow(1.0 - options.trust, weight);
  for (std::size_t d = 0; d < shape.directions; ++d) {
    for (std::size_t s = 0; s < shape.corrections; ++s) {
      const double off = wrap_quarter(wall.direction_rad - directions_rad[d] +
                                      static_cast<double>(s) * shape.step_rad());
      const double sigmas = off / sigma_rad;
      if (std::abs(sigmas) > kFarSigmas) {
        belief[d * shape.corrections + s] *= elsewhere;
        continue;
      }
      const double likelihood = 1.0 - options.trust + peak * std::exp(-sigmas * sigmas / 2.0);
      belief[d * shape.corrections + s] *= std::pow(likelihood, weight);
    }
  }
}

/// The chain with what each node's walls say already multiplied out.
struct Chain {
  Shape shape;
  std::vector<Belief> walls;                 ///< by node; empty where no wall was seen
  std::vector<std::vector<double>> kernels;  ///< into each node
  double switch_share = 0.0;
};

Chain chain_of(std::span<const HeadingNode> nodes, std::span<const WallSighting> sightings,
               std::span<const double> directions_rad, const HeadingChainOptions& options) {
  Chain chain;
  chain.shape = {static_cast<std::size_t>(options.states), directions_rad.size()};
  chain.switch_share = options.switch_share;
  chain.walls.resize(nodes.size());
  chain.kernels.resize(nodes.size());
  for (const WallSighting& wall : sightings) {
    Belief& at = chain.walls[wall.node];
    if (at.empty()) at.assign(chain.shape.size(), 1.0);
    weigh(at, wall, directions_rad, chain.shape, options);
  }
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    chain.kernels[k] = drift_kernel(nodes[k - 1], nodes[k], chain.shape, options);
  }
  return chain;
}

void multiply(Belief& belief, const Belief& by) {
  for (std::size_t s = 0; s < by.size(); ++s) belief[s] *= by[s];
}

/// Forward pass. @param keep receives the belief at each node, where given
double filter(const Chain& chain, std::vector<Belief>* keep) {
  Belief scratch;
  Belief belief(chain.shape.size(), 1.0);
  normalise(belief);
  double log_evidence = 0.0;
  for (std::size_t k = 0; k < chain.walls.size(); ++k) {
    if (k > 0) spread(belief, chain.kernels[k], chain.shape, chain.switch_share, scratch);
    multiply(belief, chain.walls[k]);
    log_evidence += std::log(normalise(belief));
    if (keep != nullptr) keep->push_back(belief);
  }
  return log_evidence;
}

/// Of the correction, whatever the direction.
Belief marginal(const Belief& belief, const Shape& shape) {
  Belief result(shape.corrections, 0.0);
  for (std::size_t i = 0; i < belief.size(); ++i) result[i % shape.corrections] += belief[i];
  return result;
}

struct Moments {
  double mean_rad = 0.0;
  double sigma_rad = 0.0;
};

/// Mean and standard deviation within 45 degrees of the mode.
Moments moments_about_mode(const Belief& belief, const Shape& shape) {
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
  return filter(chain_of(nodes, sightings, directions_rad, options), nullptr);
}

HeadingChain smooth_heading(std::span<const HeadingNode> nodes,
                            std::span<const WallSighting> sightings,
                            std::span<const double> directions_rad,
                            const HeadingChainOptions& options) {
  const Chain chain = chain_of(nodes, sightings, directions_rad, options);
  std::vector<Belief> beliefs;
  HeadingChain result;
  result.log_evidence = filter(chain, &beliefs);
  result.correction_rad.resize(nodes.size());
  result.sigma_rad.resize(nodes.size());
  Belief later(chain.shape.size(), 1.0);  // what the nodes behind say of this one
  Belief scratch;
  for (std::size_t k = nodes.size(); k-- > 0;) {
    Belief belief = beliefs[k];
    multiply(belief, later);
    const Moments moments = moments_about_mode(marginal(belief, chain.shape), chain.shape);
    result.correction_rad[k] = moments.mean_rad;
    result.sigma_rad[k] = moments.sigma_rad;
    if (k == 0) break;
    multiply(later, chain.walls[k]);
    spread(later, chain.kernels[k], chain.shape, chain.switch_share, scratch);
    normalise(later);
  }
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const double step = result.correction_rad[k] - result.correction_rad[k - 1];
    result.correction_rad[k] = result.correction_rad[k - 1] + wrap_quarter(step);
  }
  return result;
}

}  // namespace roomatlas
