// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_spread.hpp"

#include <cmath>
#include <random>
#include <utility>

#include "roomatlas/core/rigid_fit.hpp"
#include "sonar_equations.hpp"

namespace roomatlas {
namespace {

/// @param next gives a draw: x, y and heading of each node
template <typename Next>
std::vector<std::vector<Pose2>> laid_draws(const std::vector<Pose2>& map_from_node, Next&& next) {
  std::vector<std::vector<Pose2>> draws;
  draws.reserve(kDraws);
  for (int draw = 0; draw < kDraws; ++draw) {
    const std::vector<double> moves = next(draw);
    std::vector<Pose2> moved = map_from_node;
    for (std::size_t k = 0; k < moved.size(); ++k) {
      const double* const move = moves.data() + 3 * k;
      moved[k] = {moved[k].x_m + move[0], moved[k].y_m + move[1], moved[k].theta_rad + move[2]};
    }
    draws.push_back(moves_to(std::move(moved), map_from_node));
  }
  return draws;
}

}  // namespace

Pose2 fit(std::span<const Pose2> from, std::span<const Pose2> onto) {
  std::vector<PointPair> pairs;
  pairs.reserve(from.size());
  for (std::size_t k = 0; k < from.size(); ++k) {
    pairs.push_back({from[k].position(), onto[k].position()});
  }
  return rigid_fit(pairs);
}

std::vector<Pose2> moves_to(std::vector<Pose2> others, std::span<const Pose2> poses) {
  const Pose2 laid = fit(others, poses);
  for (std::size_t k = 0; k < others.size(); ++k) {
    others[k] = inverse(poses[k]) * (laid * others[k]);
  }
  return others;
}

std::vector<std::vector<Pose2>> drawn_moves(const SonarEquations& equations,
                                            const std::vector<Pose2>& map_from_node) {
  std::mt19937_64 random(1);
  return laid_draws(map_from_node, [&](int) { return equations.draw_moves(random); });
}

std::vector<std::vector<Pose2>> wild_moves(const SonarEquations& equations,
                                           const std::vector<Pose2>& map_from_node) {
  return laid_draws(map_from_node, [&](int draw) { return equations.draw_wild(draw); });
}

double apart_m(std::span<const Pose2> a, std::span<const Pose2> b) {
  if (a.empty()) return 0.0;
  const Pose2 laid = fit(a, b);
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    squares += (laid * a[i].position() - b[i].position()).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(a.size()));
}

}  // namespace roomatlas
