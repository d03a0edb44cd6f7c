// SPDX-License-Identifier: GPL-3.0-or-later
// The heading's hidden Markov model written from its definition, for tests that go through all
// paths.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "../../src/sonar/sighting_chain.hpp"
#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

/// Few states and no rounding of the kernel's tails, so that every path can be summed.
inline SightingChainOptions few_states() {
  SightingChainOptions options;
  options.states = 9;
  options.odometry.heading.per_sqrt_m = radians(12.0);
  options.segment_sigma_rad = radians(14.0);
  return options;
}

struct HeadingDefinition {
  std::vector<HeadingNode> nodes;
  std::vector<WallSighting> walls;
  SightingChainOptions options;

  [[nodiscard]] double seen(std::size_t node, int state) const {
    double product = 1.0;
    for (const WallSighting& wall : walls) {
      if (wall.node != node) continue;
      const double sigma =
          std::hypot(options.segment_sigma_rad, options.end_sigma_m / wall.length_m);
      const double off = wrap_quarter(wall.direction_rad + state * kPi / 2 / options.states);
      const double normal =
          std::exp(-off * off / (2 * sigma * sigma)) / (sigma * std::sqrt(2 * kPi));
      const double far = std::abs(off) > 5.0 * sigma ? 0.0 : normal;
      product *= std::pow(1 - options.trust + options.trust * far * kPi / 2,
                          std::min(1.0, wall.length_m / options.full_weight_m));
    }
    return product;
  }
  [[nodiscard]] double moves(std::size_t to_node, int steps) const {
    const HeadingNode& a = nodes[to_node - 1];
    const HeadingNode& b = nodes[to_node];
    const double variance =
        std::pow(options.odometry.heading.per_sqrt_m, 2) * (b.path_m - a.path_m) +
        std::pow(options.odometry.heading.per_rad * (b.turned_rad - a.turned_rad), 2) +
        std::pow(options.odometry.heading.still, 2);
    const double cell = kPi / 2 / options.states;
    const int width = std::min(options.states / 3,
                               static_cast<int>(std::ceil(4 * std::sqrt(variance) / cell)) + 1);
    const auto weight = [&](int s) {
      return std::exp(-s * s * cell * cell / (2 * variance)) + options.jump_share;
    };
    double sum = 0.0;
    for (int s = -width; s <= width; ++s) sum += weight(s);
    return std::abs(steps) <= width ? weight(steps) / sum : 0.0;
  }
};

inline std::vector<HeadingNode> four_nodes() {
  return {{0, 0}, {0.4, 0.1}, {0.9, 0.9}, {1.3, 0.9}};
}
inline std::vector<WallSighting> some_walls() {
  return {{0, radians(20.0), 1.5},
          {1, radians(118.0), 0.6},
          {1, radians(50.0), 0.9},
          {3, radians(-61.0), 2.0}};
}

}  // namespace roomatlas
