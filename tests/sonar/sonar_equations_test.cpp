// SPDX-License-Identifier: GPL-3.0-or-later
// The normal equations against the same ones in one dense matrix.
#include "../../src/sonar/sonar_equations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "support/false_loops.hpp"

namespace roomatlas {
namespace {

constexpr std::size_t kNodes = 3 * kClusterNodes;
constexpr Eigen::Index kScaleAt = 3 * kNodes;  // in the dense matrix; the second direction follows
constexpr int kWild = 48;

/// A residual between two nodes, and of the scale.
struct Joining {
  ResidualKind kind = ResidualKind::step;
  std::size_t first = 0;
  std::size_t second = 0;
  PairResidual residual;
  double by_scale = 0.0;
  double weight = 1.0;
};

std::vector<Joining> chain_with_a_loop() {
  test::Dice dice(3);
  std::vector<Joining> all;
  const auto add = [&](ResidualKind kind, std::size_t first, std::size_t second) {
    Joining one{kind, first, second, {}, dice.normal(), 1.0 + std::abs(dice.normal())};
    one.residual.value = dice.normal();
    for (double& by : one.residual.by_first) by = dice.normal();
    for (double& by : one.residual.by_second) by = dice.normal();
    all.push_back(one);
  };
  for (std::size_t k = 1; k < kNodes; ++k) {
    for (int i = 0; i < 4; ++i) add(ResidualKind::step, k - 1, k);
  }
  for (int i = 0; i < 3; ++i) add(ResidualKind::pair, kNodes - 2, 3);
  return all;
}

constexpr std::size_t kDirected =
    kClusterNodes + 5;  // the node whose heading is held to a direction
constexpr double kDirectedOff = 0.3;
constexpr double kDirectionOff = -0.1;
constexpr double kDirectedWeight = 2.0;

SonarEquations sparse(const std::vector<Joining>& all) {
  std::vector<NodePair> pairs;
  pairs.reserve(all.size());
  for (const Joining& one : all) {
    pairs.emplace_back(static_cast<std::int32_t>(one.first), static_cast<std::int32_t>(one.second));
  }
  SonarEquations equations(kNodes, pairs, 2, kWild);
  equations.clear();
  equations.hold(0, 1.0);
  for (const Joining& one : all) {
    equations.begin(one.kind, one.first, one.second);
    const PairPlaces places = equations.places_of(one.first, one.second);
    equations.add(places, one.residual, one.weight);
    equations.add_scale(places, one.residual, one.by_scale, one.weight);
  }
  equations.begin(ResidualKind::heading, kDirected, kDirected);
  equations.add_heading(kDirected, 1, kDirectedOff, kDirectedWeight);
  equations.add_direction(1, kDirectionOff, kDirectedWeight);
  return equations;
}

using Cluster = std::tuple<ResidualKind, std::size_t, std::size_t>;

struct Dense {
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(kScaleAt + 2, kScaleAt + 2);
  std::map<Cluster, Eigen::VectorXd> pulls;  ///< of the right side, what each cluster is

  void add(const Cluster& cluster, const Eigen::VectorXd& by, double value, double weight) {
    normal += weight * by * by.transpose();
    pulls.try_emplace(cluster, Eigen::VectorXd::Zero(by.size())).first->second -=
        weight * value * by;
  }
};

Dense dense(const std::vector<Joining>& all) {
  Dense equations;
  equations.normal.topLeftCorner(3, 3).diagonal().setOnes();
  for (const Joining& one : all) {
    Eigen::VectorXd by = Eigen::VectorXd::Zero(kScaleAt + 2);
    for (std::size_t i = 0; i < 3; ++i) {
      by[static_cast<Eigen::Index>(3 * one.first + i)] = one.residual.by_first[i];
      by[static_cast<Eigen::Index>(3 * one.second + i)] = one.residual.by_second[i];
    }
    by[kScaleAt] = one.by_scale;
    const std::size_t low = std::min(one.first, one.second) / kClusterNodes;
    const std::size_t high = std::max(one.first, one.second) / kClusterNodes;
    equations.add({one.kind, low, high}, by, one.residual.value, one.weight);
  }
  Eigen::VectorXd by = Eigen::VectorXd::Zero(kScaleAt + 2);
  by[3 * kDirected + 2] = 1.0;
  by[kScaleAt + 1] = -1.0;
  equations.add({ResidualKind::heading, 1, 1}, by, kDirectedOff, kDirectedWeight);
  const Eigen::VectorXd of_direction = Eigen::VectorXd::Unit(kScaleAt + 2, kScaleAt + 1);
  equations.add({ResidualKind::heading, 1, 1}, of_direction, kDirectionOff, kDirectedWeight);
  return equations;
}

TEST(SonarEquations, SolveAsOneDenseMatrixDoes) {
  const std::vector<Joining> all = chain_with_a_loop();
  const Dense expected = dense(all);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(kScaleAt + 2);
  for (const auto& [cluster, pull] : expected.pulls) right += pull;
  const Eigen::VectorXd step = expected.normal.ldlt().solve(right);

  std::vector<Pose2> poses(kNodes);
  SharedUnknowns shared{1.0, {0.0, 0.0}};
  ASSERT_GT(sparse(all).solve(poses, shared), 0.0);
  EXPECT_NEAR(shared.length_scale, 1.0 + step[kScaleAt], 1e-9);
  EXPECT_NEAR(shared.directions_rad[1], step[kScaleAt + 1], 1e-9);
  for (std::size_t k = 0; k < kNodes; ++k) {
    EXPECT_NEAR(poses[k].x_m, step[static_cast<Eigen::Index>(3 * k)], 1e-9) << k;
    EXPECT_NEAR(poses[k].y_m, step[static_cast<Eigen::Index>(3 * k + 1)], 1e-9) << k;
  }
}

/// Each wild draw is a sum of what the clusters move, with signs; all clusters take both.
TEST(SonarEquations, DrawWithASignForEachCluster) {
  const std::vector<Joining> all = chain_with_a_loop();
  const Dense expected = dense(all);
  ASSERT_EQ(expected.pulls.size(), 7U);  // of steps 3 and 2 between them, a loop, a direction
  Eigen::MatrixXd moved(3 * kNodes, 7);
  const Eigen::LDLT<Eigen::MatrixXd> factors(expected.normal);
  Eigen::Index column = 0;
  for (const auto& [cluster, pull] : expected.pulls) {
    moved.col(column++) = factors.solve(pull).head(3 * kNodes);
  }
  std::vector<Pose2> poses(kNodes);
  SharedUnknowns shared{1.0, {0.0, 0.0}};
  SonarEquations equations = sparse(all);
  ASSERT_GT(equations.solve(poses, shared), 0.0);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(7);
  for (int draw = 0; draw < kWild; ++draw) {
    const std::vector<double> moves = equations.draw_wild(draw);
    const Eigen::Map<const Eigen::VectorXd> wild(moves.data(), 3 * kNodes);
    const Eigen::VectorXd signs = moved.colPivHouseholderQr().solve(wild);
    EXPECT_LT((moved * signs - wild).norm(), 1e-9 * wild.norm());
    for (const double sign : signs) EXPECT_NEAR(std::abs(sign), 1.0, 1e-6);
    sums += signs;
  }
  // independent fair signs stay within four deviations
  EXPECT_LT(sums.cwiseAbs().maxCoeff(), 4.0 * std::sqrt(kWild));
}

}  // namespace
}  // namespace roomatlas
