// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

#include "support/false_loops.hpp"

namespace roomatlas::test {

struct GeneratedGraph {
  PoseGraph graph;  ///< without a guess
  std::vector<Pose2> truth;
};

inline PoseEdge noisy_edge(const std::vector<Pose2>& truth, std::int32_t from, std::int32_t to,
                           double sigma_m, double sigma_rad, Dice& dice) {
  PoseEdge edge;
  edge.from = from;
  edge.to = to;
  edge.kind = std::abs(to - from) == 1 ? EdgeKind::odometry : EdgeKind::loop;
  const Pose2 step =
      inverse(truth[static_cast<std::size_t>(from)]) * truth[static_cast<std::size_t>(to)];
  const Pose2 noise{sigma_m * dice.normal(), sigma_m * dice.normal(), sigma_rad * dice.normal()};
  edge.from_from_to = step * noise;
  edge.information = Eigen::Vector3d(1.0 / (sigma_m * sigma_m), 1.0 / (sigma_m * sigma_m),
                                     1.0 / (sigma_rad * sigma_rad))
                         .asDiagonal();
  return edge;
}

/// A building of about `rooms` rooms of 4 m in a square raster, each turned at random, joined by
/// doors: a random tree and as many more as make `doors_a_room`. Noise: `noise` times the distance
/// and `noise` radians.
inline GeneratedGraph room_graph(std::int32_t rooms, std::uint64_t seed = 1,
                                 double doors_a_room = 1.3, double noise = 0.02) {
  constexpr double kRoom_m = 4.0;
  Dice dice(seed);
  const auto side = static_cast<std::int32_t>(std::sqrt(static_cast<double>(rooms)));
  const std::int32_t n = side * side;
  GeneratedGraph result;
  for (std::int32_t i = 0; i < n; ++i) {
    result.graph.ids.push_back(i);
    result.truth.push_back({kRoom_m * (i % side), kRoom_m * static_cast<double>(i / side),
                            i == 0 ? 0.0 : 2.0 * kPi * dice.uniform() - kPi});
  }
  std::vector<std::pair<std::int32_t, std::int32_t>> walls;
  for (std::int32_t i = 0; i < n; ++i) {
    if (i % side + 1 < side) walls.emplace_back(i, i + 1);
    if (i + side < n) walls.emplace_back(i, i + side);
  }
  for (std::size_t k = walls.size(); k-- > 1;) {
    std::swap(walls[k], walls[static_cast<std::size_t>(dice.below(static_cast<int>(k) + 1))]);
  }
  std::vector<std::int32_t> root(static_cast<std::size_t>(n));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](std::int32_t a) {
    while (root[static_cast<std::size_t>(a)] != a) {
      auto& up = root[static_cast<std::size_t>(a)];
      up = root[static_cast<std::size_t>(up)];
      a = up;
    }
    return a;
  };
  auto more = static_cast<std::ptrdiff_t>((doors_a_room - 1.0) * n) + 1;
  for (const auto& [a, b] : walls) {
    const std::int32_t root_a = find(a);
    const std::int32_t root_b = find(b);
    if (root_a == root_b && more-- <= 0) continue;
    root[static_cast<std::size_t>(root_a)] = root_b;
    result.graph.edges.push_back(noisy_edge(result.truth, a, b, noise * kRoom_m, noise, dice));
  }
  return result;
}

/// A closed walk of `nodes` steps of 1 m on a circle.
inline GeneratedGraph ring_graph(std::int32_t nodes, double sigma_m, double sigma_rad,
                                 std::uint64_t seed) {
  Dice dice(seed);
  GeneratedGraph result;
  const double turn = 2.0 * kPi / nodes;
  Pose2 at;
  for (std::int32_t i = 0; i < nodes; ++i) {
    result.graph.ids.push_back(i);
    result.truth.push_back(at);
    at = at * Pose2{1.0, 0.0, turn};
  }
  for (std::int32_t i = 0; i < nodes; ++i) {
    result.graph.edges.push_back(
        noisy_edge(result.truth, i, (i + 1) % nodes, sigma_m, sigma_rad, dice));
  }
  return result;
}

/// A walk in a raster of 1 m that meets itself: steps as odometry, and loops where it comes within
/// 2 m of where it was, one in three.
inline GeneratedGraph walk_graph(std::int32_t nodes, double sigma_m, double sigma_rad,
                                 std::uint64_t seed) {
  Dice dice(seed);
  GeneratedGraph result;
  const std::int32_t side = std::max(4, static_cast<std::int32_t>(std::sqrt(nodes)));
  Pose2 at;
  for (std::int32_t i = 0; i < nodes; ++i) {
    result.graph.ids.push_back(i);
    result.truth.push_back(at);
    const bool straight = dice.uniform() < 0.6;
    double turn = straight ? 0.0 : (dice.uniform() < 0.5 ? kPi / 2.0 : -kPi / 2.0);
    Pose2 next = at * Pose2{1.0, 0.0, turn};
    if (std::abs(next.x_m) > side / 2.0 || std::abs(next.y_m) > side / 2.0) {
      next = at * Pose2{0.0, 0.0, kPi / 2.0};  // turns away from the border
    }
    at = next;
  }
  for (std::int32_t i = 0; i + 1 < nodes; ++i) {
    result.graph.edges.push_back(noisy_edge(result.truth, i, i + 1, sigma_m, sigma_rad, dice));
  }
  for (std::int32_t i = 0; i < nodes; ++i) {
    for (std::int32_t j = i + 10; j < nodes; ++j) {
      const Point2 apart = result.truth[static_cast<std::size_t>(i)].position() -
                           result.truth[static_cast<std::size_t>(j)].position();
      if (apart.norm() > 2.0 || dice.uniform() > 0.1) continue;
      result.graph.edges.push_back(noisy_edge(result.truth, i, j, sigma_m, sigma_rad, dice));
    }
  }
  return result;
}

}  // namespace roomatlas::test
