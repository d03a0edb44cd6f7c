// SPDX-License-Identifier: GPL-3.0-or-later
#include "heading_slips.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "heading_beliefs.hpp"

namespace roomatlas {
namespace {

/// A path drawn from the posterior: corrections in states, unwrapped, by node.
std::vector<int> drawn_path(const HeadingModel& model, const std::vector<Belief>& filtered,
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
  const auto count = static_cast<int>(model.shape.corrections);
  const auto directions = model.shape.directions;
  std::vector<int> path(filtered.size());
  std::size_t state = draw(filtered.back());
  path.back() = static_cast<int>(state % model.shape.corrections);
  Belief weights;
  for (std::size_t k = filtered.size() - 1; k-- > 0;) {
    const auto& kernel = model.kernels[k + 1];
    const int width = static_cast<int>(kernel.size() / 2);
    const int correction = static_cast<int>(state % model.shape.corrections);
    const std::size_t direction = state / model.shape.corrections;
    weights.clear();
    for (std::size_t d = 0; d < directions; ++d) {
      const double stays = d == direction
                               ? 1.0 - (directions > 1 ? model.switch_share : 0.0)
                               : model.switch_share / static_cast<double>(directions - 1);
      for (int step = -width; step <= width; ++step) {
        const int from = (correction + step + count) % count;
        const std::size_t at = d * model.shape.corrections + static_cast<std::size_t>(from);
        weights.push_back(stays * kernel[static_cast<std::size_t>(step + width)] * filtered[k][at]);
      }
    }
    const auto drawn = static_cast<int>(draw(weights));
    const int step = drawn % (2 * width + 1) - width;
    path[k] = path[k + 1] + step;
    state = static_cast<std::size_t>(drawn / (2 * width + 1)) * model.shape.corrections +
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

std::vector<HeadingSlip> find_slips(std::span<const HeadingNode> nodes,
                                    std::span<const WallSighting> sightings,
                                    std::span<const double> directions_rad,
                                    const HeadingChainOptions& options,
                                    const std::vector<double>& mean_rad) {
  if (sightings.empty()) return {};
  const HeadingModel model = heading_model(nodes, sightings, directions_rad, options);
  std::vector<Belief> filtered;
  (void)filter(model, &filtered);
  std::mt19937_64 engine(20231);                // any number: the paths must be the same each time
  std::vector<std::vector<double>> beyond_rad;  // of each path, against the mean
  std::vector<Parting> partings;
  for (std::size_t path = 0; path < kDrawnPaths; ++path) {
    const std::vector<int> drawn = drawn_path(model, filtered, engine);
    std::vector<double> beyond;
    int winding = 0;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      beyond.push_back(drawn[k] * model.shape.step_rad() - mean_rad[k]);
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
