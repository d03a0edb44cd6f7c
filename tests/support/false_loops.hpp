// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "roomatlas/solve/pose_graph.hpp"

namespace roomatlas::test {

enum class FalseLoops {
  single,      ///< each by itself, between any two nodes: "the same place, nearly"
  grouped,     ///< runs of five: the robot is said to drive where it drove before
  consistent,  ///< runs of five that odometry bears out among themselves
};

/// Uniform in [0, 1), the same with every standard library.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  std::int32_t below(std::int32_t end) { return static_cast<std::int32_t>(uniform() * end); }
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * kPi * uniform());
  }

 private:
  std::mt19937_64 engine_;
};

/// Adds false loops behind the edges of a graph whose odometry joins node k and k + 1, both by
/// index. @param share of the number of loops that the graph has
inline PoseGraph with_false_loops(PoseGraph graph, double share, FalseLoops kind,
                                  std::uint64_t seed) {
  constexpr std::int32_t kGroup = 5;
  Dice dice(seed);
  const auto n = static_cast<std::int32_t>(graph.ids.size());
  std::vector<const PoseEdge*> step(graph.ids.size(), nullptr);
  std::vector<Eigen::Matrix3d> informations;
  for (const PoseEdge& edge : graph.edges) {
    if (edge.kind == EdgeKind::loop) informations.push_back(edge.information);
    if (edge.to - edge.from == 1) step[static_cast<std::size_t>(edge.from)] = &edge;
  }
  const auto wanted =
      static_cast<std::ptrdiff_t>(std::llround(share * static_cast<double>(informations.size())));
  std::vector<PoseEdge> added;
  while (std::ssize(added) < wanted) {
    const std::int32_t size = kind == FalseLoops::single ? 1 : kGroup;
    const std::int32_t from = dice.below(n - size);
    const std::int32_t to = dice.below(n - size);
    if (std::abs(from - to) < std::max(20, 2 * size)) continue;
    Pose2 said{0.3 * dice.normal(), 0.3 * dice.normal(), radians(10.0) * dice.normal()};
    const auto information =
        informations[static_cast<std::size_t>(dice.below(static_cast<int>(informations.size())))];
    for (std::int32_t k = 0; k < size && std::ssize(added) < wanted; ++k) {
      added.push_back({from + k, to + k, EdgeKind::loop, said, information});
      const PoseEdge* a = step[static_cast<std::size_t>(from + k)];
      const PoseEdge* b = step[static_cast<std::size_t>(to + k)];
      if (kind == FalseLoops::consistent && a != nullptr && b != nullptr) {
        said = inverse(a->from_from_to) * said * b->from_from_to;
      } else {
        said = {0.3 * dice.normal(), 0.3 * dice.normal(), radians(10.0) * dice.normal()};
      }
    }
  }
  graph.edges.insert(graph.edges.end(), added.begin(), added.end());
  return graph;
}

/// Root mean square distance after the best rigid alignment (Umeyama 1991, without scale).
inline double aligned_rmse_m(const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
  Point2 mean_a = Point2::Zero();
  Point2 mean_b = Point2::Zero();
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i].position() / static_cast<double>(a.size());
    mean_b += b[i].position() / static_cast<double>(a.size());
  }
  double dot = 0.0;
  double cross = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point2 p = a[i].position() - mean_a;
    const Point2 q = b[i].position() - mean_b;
    dot += p.dot(q);
    cross += p.x() * q.y() - p.y() * q.x();
  }
  const Pose2 turn{0.0, 0.0, std::atan2(cross, dot)};
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (turn * Point2(a[i].position() - mean_a) - (b[i].position() - mean_b)).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace roomatlas::test
