// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_spread.hpp"

#include <cmath>
#include <random>
#include <utility>

#include "roomatlas/core/rigid_fit.hpp"
#include "sonar_equations.hpp"

namespace roomatlas {
namespace {

/// @param moves x, y and heading of each node
std::vector<Pose2> moved_by(const std::vector<double>& moves, std::vector<Pose2> poses) {
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const double* const move = moves.data() + 3 * k;
    poses[k] = {poses[k].x_m + move[0], poses[k].y_m + move[1], poses[k].theta_rad + move[2]};
  }
  return poses;
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
  std::vector<std::vector<Pose2>> drawn;
  drawn.reserve(kDraws);
  std::mt19937_64 random(1);
  for (int draw = 0; draw < kDraws; ++draw) {
    drawn.push_back(moves_to(moved_by(equations.draw_moves(random), map_from_node), map_from_node));
  }
  return drawn;
}

std::vector<std::vector<Pose2>> wild_moves(const SonarEquations& equations,
                                           const std::vector<Pose2>& map_from_node) {
  std::vector<std::vector<Pose2>> drawn;
  drawn.reserve(kDraws);
  for (int draw = 0; draw < kDraws; ++draw) {
    drawn.push_back(moves_to(moved_by(equations.draw_wild(draw), map_from_node), map_from_node));
  }
  return drawn;
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
