// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_spread.hpp"

#include <cmath>
#include <random>
#include <utility>

#include "roomatlas/core/rigid_fit.hpp"
#include "sonar_equations.hpp"

namespace roomatlas {
namespace {

constexpr int kDraws = 48;  // tell a standard deviation to a tenth; a draw costs half a solution

}  // namespace

Pose2 fit(std::span<const Pose2> from, std::span<const Pose2> onto) {
  std::vector<PointPair> pairs;
  pairs.reserve(from.size());
  for (std::size_t k = 0; k < from.size(); ++k) {
    pairs.push_back({from[k].position(), onto[k].position()});
  }
  return rigid_fit(pairs);
}

std::vector<std::vector<Pose2>> drawn_moves(const SonarEquations& equations,
                                            const std::vector<Pose2>& map_from_node) {
  std::vector<std::vector<Pose2>> drawn;
  std::mt19937_64 random(1);
  for (int draw = 0; draw < kDraws; ++draw) {
    const std::vector<double> moves = equations.draw_moves(random);
    std::vector<Pose2> moved = map_from_node;
    for (std::size_t k = 0; k < moved.size(); ++k) {
      const double* const move = moves.data() + 3 * k;
      moved[k] = {moved[k].x_m + move[0], moved[k].y_m + move[1], moved[k].theta_rad + move[2]};
    }
    const Pose2 laid = fit(moved, map_from_node);
    for (std::size_t k = 0; k < moved.size(); ++k) {
      moved[k] = inverse(map_from_node[k]) * (laid * moved[k]);
    }
    drawn.push_back(std::move(moved));
  }
  return drawn;
}

std::vector<PoseSpread> spread_of(const std::vector<std::vector<Pose2>>& moves) {
  if (moves.empty()) return {};
  std::vector<PoseSpread> squares(moves.front().size(), {0.0, 0.0});
  for (const std::vector<Pose2>& draw : moves) {
    for (std::size_t k = 0; k < draw.size(); ++k) {
      squares[k].place_m += draw[k].position().squaredNorm();
      squares[k].heading_rad += draw[k].theta_rad * draw[k].theta_rad;
    }
  }
  const auto draws = static_cast<double>(moves.size());
  for (PoseSpread& one : squares) {
    one = {std::sqrt(one.place_m / draws), std::sqrt(one.heading_rad / draws)};
  }
  return squares;
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
