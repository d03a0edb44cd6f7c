// SPDX-License-Identifier: GPL-3.0-or-later
#include "heading_beliefs.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

/// Weights of the steps -width to width of the correction, which sum to 1.
std::vector<double> drift_kernel(const HeadingNode& from, const HeadingNode& to,
                                 const BeliefShape& shape, const HeadingChainOptions& options) {
  const double by_turn = options.drift_per_turn * (to.turned_rad - from.turned_rad);
  const double by_way = options.drift_rad_per_sqrt_m;
  const double sigma_rad = std::sqrt(by_way * by_way * (to.path_m - from.path_m) +
                                     by_turn * by_turn + options.base_rad * options.base_rad);
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

/// Multiplies a belief by what one wall says of it.
void weigh(Belief& belief, const WallSighting& wall, std::span<const double> directions_rad,
           const BeliefShape& shape, const HeadingChainOptions& options) {
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

}  // namespace

double normalise(Belief& belief) {
  double sum = 0.0;
  for (const double value : belief) sum += value;
  for (double& value : belief) value /= sum;
  return sum;
}

void spread(Belief& belief, const std::vector<double>& kernel, const BeliefShape& shape,
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

void multiply(Belief& belief, const Belief& by) {
  for (std::size_t s = 0; s < by.size(); ++s) belief[s] *= by[s];
}

HeadingModel heading_model(std::span<const HeadingNode> nodes,
                           std::span<const WallSighting> sightings,
                           std::span<const double> directions_rad,
                           const HeadingChainOptions& options) {
  HeadingModel model;
  model.shape = {static_cast<std::size_t>(options.states), directions_rad.size()};
  model.switch_share = options.switch_share;
  model.walls.resize(nodes.size());
  model.kernels.resize(nodes.size());
  for (const WallSighting& wall : sightings) {
    Belief& at = model.walls[wall.node];
    if (at.empty()) at.assign(model.shape.size(), 1.0);
    weigh(at, wall, directions_rad, model.shape, options);
  }
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    model.kernels[k] = drift_kernel(nodes[k - 1], nodes[k], model.shape, options);
  }
  return model;
}

double filter(const HeadingModel& model, std::vector<Belief>* keep) {
  Belief scratch;
  Belief belief(model.shape.size(), 1.0);
  normalise(belief);
  double log_evidence = 0.0;
  for (std::size_t k = 0; k < model.walls.size(); ++k) {
    if (k > 0) spread(belief, model.kernels[k], model.shape, model.switch_share, scratch);
    multiply(belief, model.walls[k]);
    log_evidence += std::log(normalise(belief));
    if (keep != nullptr) keep->push_back(belief);
  }
  return log_evidence;
}

}  // namespace roomatlas
