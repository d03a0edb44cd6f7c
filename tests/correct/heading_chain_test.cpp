// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/correct/heading_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/correct/wall_direction.hpp"

namespace roomatlas {
namespace {

const std::vector<double> kOne = {0.0};

/// Few states and no rounding of the kernel's tails, so that every path can be summed.
HeadingChainOptions small() {
  HeadingChainOptions options;
  options.states = 9;
  options.drift_rad_per_sqrt_m = radians(12.0);
  options.segment_sigma_rad = radians(14.0);
  return options;
}

/// Sum over every path of states, written from the model's definition.
class BruteForce {
 public:
  BruteForce(std::vector<HeadingNode> nodes, std::vector<WallSighting> walls,
             const HeadingChainOptions& options)
      : nodes_(std::move(nodes)), walls_(std::move(walls)), options_(options) {
    weight_.assign(nodes_.size(), std::vector<double>(count(), 0.0));
    std::vector<std::size_t> path;
    walk(path, 1.0 / static_cast<double>(count()));
  }
  [[nodiscard]] double evidence() const { return total_; }
  [[nodiscard]] double share(std::size_t node, std::size_t state) const {
    return weight_[node][state] / total_;
  }

 private:
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(options_.states); }
  [[nodiscard]] double seen(std::size_t node, std::size_t state) const {
    double product = 1.0;
    for (const WallSighting& wall : walls_) {
      if (wall.node != node) continue;
      const double sigma =
          std::hypot(options_.segment_sigma_rad, options_.end_sigma_m / wall.length_m);
      const double off =
          wrap_quarter(wall.direction_rad + static_cast<double>(state) * kPi / 2 / options_.states);
      const double normal =
          std::exp(-off * off / (2 * sigma * sigma)) / (sigma * std::sqrt(2 * kPi));
      const double far = std::abs(off) > 5.0 * sigma ? 0.0 : normal;
      product *= std::pow(1 - options_.trust + options_.trust * far * kPi / 2,
                          std::min(1.0, wall.length_m / options_.full_weight_m));
    }
    return product;
  }
  [[nodiscard]] double moves(std::size_t to_node, int steps) const {
    const HeadingNode& a = nodes_[to_node - 1];
    const HeadingNode& b = nodes_[to_node];
    const double variance = std::pow(options_.drift_rad_per_sqrt_m, 2) * (b.path_m - a.path_m) +
                            std::pow(options_.drift_per_turn * (b.turned_rad - a.turned_rad), 2) +
                            std::pow(options_.base_rad, 2);
    const double cell = kPi / 2 / options_.states;
    const int width = std::min(options_.states / 3,
                               static_cast<int>(std::ceil(4 * std::sqrt(variance) / cell)) + 1);
    const auto weight = [&](int s) {
      return std::exp(-s * s * cell * cell / (2 * variance)) + options_.jump_share;
    };
    double sum = 0.0;
    for (int s = -width; s <= width; ++s) sum += weight(s);
    return std::abs(steps) <= width ? weight(steps) / sum : 0.0;
  }
  void walk(std::vector<std::size_t>& path, double product) {
    const std::size_t node = path.size();
    if (node == nodes_.size()) {
      total_ += product;
      for (std::size_t k = 0; k < node; ++k) weight_[k][path[k]] += product;
      return;
    }
    for (std::size_t state = 0; state < count(); ++state) {
      double step = 1.0;
      if (node > 0) {
        const int n = options_.states;
        int moved = (static_cast<int>(state) - static_cast<int>(path.back()) + n) % n;
        if (moved > n / 2) moved -= n;
        step = moves(node, moved);
      }
      path.push_back(state);
      walk(path, product * step * seen(node, state));
      path.pop_back();
    }
  }

  std::vector<HeadingNode> nodes_;
  std::vector<WallSighting> walls_;
  HeadingChainOptions options_;
  std::vector<std::vector<double>> weight_;
  double total_ = 0.0;
};

std::vector<HeadingNode> four_nodes() { return {{0, 0}, {0.4, 0.1}, {0.9, 0.9}, {1.3, 0.9}}; }
std::vector<WallSighting> some_walls() {
  return {{0, radians(20.0), 1.5},
          {1, radians(118.0), 0.6},
          {1, radians(50.0), 0.9},
          {3, radians(-61.0), 2.0}};
}

TEST(HeadingChain, HasTheEvidenceOfAllPathsSummed) {
  const BruteForce oracle(four_nodes(), some_walls(), small());
  EXPECT_NEAR(heading_evidence(four_nodes(), some_walls(), kOne, small()),
              std::log(oracle.evidence()), 1e-9);
}

TEST(HeadingChain, HasTheMeanOfAllPathsAboutTheMode) {
  const BruteForce oracle(four_nodes(), some_walls(), small());
  const HeadingChain chain = smooth_heading(four_nodes(), some_walls(), kOne, small());
  for (std::size_t node = 0; node < 4; ++node) {
    std::size_t mode = 0;
    for (std::size_t s = 1; s < 9; ++s) {
      if (oracle.share(node, s) > oracle.share(node, mode)) mode = s;
    }
    double mean = 0.0;
    double weight = 0.0;
    for (int step = -4; step < 4; ++step) {
      const double share =
          oracle.share(node, static_cast<std::size_t>((static_cast<int>(mode) + step + 9) % 9));
      weight += share;
      mean += share * step;
    }
    const double expected = (static_cast<double>(mode) + mean / weight) * radians(10.0);
    EXPECT_NEAR(wrap_quarter(chain.correction_rad[node] - expected), 0.0, 1e-9) << node;
  }
}

/// Walls of a building that odometry sees turn by so much a node.
std::vector<WallSighting> drifting(std::size_t nodes, double deg_per_node) {
  std::vector<WallSighting> walls;
  for (std::size_t k = 0; k < nodes; ++k) {
    walls.push_back({k, wrap_angle(radians(deg_per_node * static_cast<double>(k))), 1.5});
  }
  return walls;
}
std::vector<HeadingNode> every_third_of_a_metre(std::size_t nodes) {
  std::vector<HeadingNode> result;
  for (std::size_t k = 0; k < nodes; ++k) result.push_back({0.3 * static_cast<double>(k), 0.0});
  return result;
}

TEST(HeadingChain, FollowsADriftBeyondNinetyDegrees) {
  const auto chain = smooth_heading(every_third_of_a_metre(300), drifting(300, 0.5), kOne, {});
  const double turned = chain.correction_rad.back() - chain.correction_rad.front();
  EXPECT_NEAR(degrees(turned), -149.5, 4.0);  // the ends lag: drift is not foreseen
  EXPECT_LT(degrees(chain.sigma_rad[150]), 2.0);
}

TEST(HeadingChain, KeepsOdometryWhereThereAreNoWalls) {
  const auto chain = smooth_heading(every_third_of_a_metre(50), {}, kOne, {});
  EXPECT_NEAR(chain.log_evidence, 0.0, 1e-9);
  for (const double correction : chain.correction_rad) {
    EXPECT_NEAR(correction, chain.correction_rad.front(), 1e-9);
  }
  EXPECT_GT(degrees(chain.sigma_rad[25]), 20.0);
}

TEST(HeadingChain, PrefersWallsThatAgree) {
  const auto nodes = every_third_of_a_metre(100);
  const double agreed = heading_evidence(nodes, drifting(100, 0.0), kOne, {});
  EXPECT_GT(agreed, 100.0);
  EXPECT_LT(heading_evidence(nodes, drifting(100, 37.0), kOne, {}), 0.0);
}

}  // namespace
}  // namespace roomatlas
