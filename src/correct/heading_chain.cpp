// SPDX-License-Identifier: GPL-3.0-or-later
#include "heading_chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

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

/// A path drawn from the posterior: corrections in states, unwrapped, by node.
std::vector<int> drawn_path(const Chain& chain, const std::vector<Belief>& filtered,
                            std::mt19937_64& engine) {
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  const auto draw = [&](const Belief& weights) {
    double sum = 0.0;
    for (const double weight : weights) sum += weight;
    double left = uniform() * sum;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      left -= weights[i];
      if (left < 0.0) return i;
    }
    return weights.size() - 1;
  };
  const auto count = static_cast<int>(chain.shape.corrections);
  const auto directions = chain.shape.directions;
  std::vector<int> path(filtered.size());
  std::size_t state = draw(filtered.back());
  path.back() = static_cast<int>(state % chain.shape.corrections);
  Belief weights;
  for (std::size_t k = filtered.size() - 1; k-- > 0;) {
    const auto& kernel = chain.kernels[k + 1];
    const int width = static_cast<int>(kernel.size() / 2);
    const int correction = static_cast<int>(state % chain.shape.corrections);
    const std::size_t direction = state / chain.shape.corrections;
    weights.clear();
    for (std::size_t d = 0; d < directions; ++d) {
      const double stays = d == direction
                               ? 1.0 - (directions > 1 ? chain.switch_share : 0.0)
                               : chain.switch_share / static_cast<double>(directions - 1);
      for (int step = -width; step <= width; ++step) {
        const int from = (correction + step + count) % count;
        const std::size_t at = d * chain.shape.corrections + static_cast<std::size_t>(from);
        weights.push_back(stays * kernel[static_cast<std::size_t>(step + width)] * filtered[k][at]);
      }
    }
    const auto drawn = static_cast<int>(draw(weights));
    const int step = drawn % (2 * width + 1) - width;
    path[k] = path[k + 1] + step;
    state = static_cast<std::size_t>(drawn / (2 * width + 1)) * chain.shape.corrections +
            static_cast<std::size_t>((correction + step + count) % count);
  }
  return path;
}

/// Where a drawn path leaves the mean's winding for the next one.
struct Parting {
  std::size_t node = 0;
  int sign = 0;
  std::size_t path = 0;
};

constexpr std::size_t kDrawnPaths = 200;
constexpr std::size_t kTogether = 12;  // nodes; partings this near to each other are one slip
constexpr double kAgreeRad = radians(10.0);
constexpr std::size_t kLongest = 200;  // nodes to either side

/// The mean way, beyond the posterior's mean, of the paths that part here.
HeadingSlip slip_of(std::span<const Parting> partings,
                    const std::vector<std::vector<double>>& beyond_rad) {
  std::size_t first = partings.front().node;
  std::size_t last = first;
  for (const Parting& parting : partings) {
    first = std::min(first, parting.node);
    last = std::max(last, parting.node);
  }
  const double quarter = partings.front().sign * kPi / 2.0;
  const auto beyond_at = [&](std::size_t node) {
    double sum = 0.0;
    for (const Parting& parting : partings) {
      const std::vector<double>& beyond = beyond_rad[parting.path];
      const double before = std::round(beyond[parting.node - 1] / (kPi / 2.0)) * (kPi / 2.0);
      sum += beyond[node] - before;
    }
    return sum / static_cast<double>(partings.size());
  };
  // from the last node at which they still agree with the mean to the first at which they have
  // turned by all of it
  const std::size_t least = first > kLongest ? first - kLongest : 0;
  const std::size_t most = std::min(beyond_rad.front().size() - 1, last + kLongest);
  while (first > least && std::abs(beyond_at(first)) > kAgreeRad) --first;
  while (last < most && std::abs(beyond_at(last) - quarter) > kAgreeRad) {
    ++last;
  }
  HeadingSlip slip;
  slip.first_node = first;
  slip.share = static_cast<double>(partings.size()) / static_cast<double>(kDrawnPaths);
  for (std::size_t k = first; k < last; ++k) {
    slip.more_rad.push_back(
        std::clamp(beyond_at(k), std::min(0.0, quarter), std::max(0.0, quarter)));
  }
  slip.more_rad.push_back(quarter);
  return slip;
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

std::vector<HeadingSlip> find_slips(std::span<const HeadingNode> nodes,
                                    std::span<const WallSighting> sightings,
                                    std::span<const double> directions_rad,
                                    const HeadingChainOptions& options,
                                    const std::vector<double>& mean_rad) {
  if (sightings.empty()) return {};
  const Chain chain = chain_of(nodes, sightings, directions_rad, options);
  std::vector<Belief> filtered;
  (void)filter(chain, &filtered);
  std::mt19937_64 engine(20231);                // any number: the paths must be the same each time
  std::vector<std::vector<double>> beyond_rad;  // of each path, against the mean
  std::vector<Parting> partings;
  for (std::size_t path = 0; path < kDrawnPaths; ++path) {
    const std::vector<int> drawn = drawn_path(chain, filtered, engine);
    std::vector<double> beyond;
    int winding = 0;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      beyond.push_back(drawn[k] * chain.shape.step_rad() - mean_rad[k]);
      const double quarters = beyond.back() / (kPi / 2.0);
      // a path that only strays leaves its winding late
      constexpr double kStray = 0.6;
      if (k == 0) winding = static_cast<int>(std::lround(quarters));
      if (std::abs(quarters - winding) > kStray) {
        const int now = static_cast<int>(std::lround(quarters));
        partings.push_back({k, now > winding ? 1 : -1, path});
        winding = now;
      }
    }
    beyond_rad.push_back(std::move(beyond));
  }
  std::sort(partings.begin(), partings.end(), [](const Parting& a, const Parting& b) {
    if (a.sign != b.sign) return a.sign < b.sign;
    return a.node != b.node ? a.node < b.node : a.path < b.path;
  });
  std::vector<HeadingSlip> slips;
  for (std::size_t first = 0; first < partings.size();) {
    std::size_t end = first + 1;
    while (end < partings.size() && partings[end].sign == partings[first].sign &&
           partings[end].node <= partings[first].node + kTogether) {
      ++end;
    }
    slips.push_back(slip_of(std::span(partings).subspan(first, end - first), beyond_rad));
    first = end;
  }
  std::stable_sort(slips.begin(), slips.end(),
                   [](const HeadingSlip& a, const HeadingSlip& b) { return a.share > b.share; });
  return slips;
}

}  // namespace roomatlas
