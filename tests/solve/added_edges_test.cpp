// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/solve/added_edges.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <random>
#include <stdexcept>

#include "roomatlas/solve/optimize.hpp"

namespace roomatlas {
namespace {

/// Two corridors of eight nodes each without a loop, measured as they lie.
PoseGraph two_chains() {
  PoseGraph graph;
  for (std::int64_t chain = 0; chain < 2; ++chain) {
    Pose2 at{20.0 * static_cast<double>(chain), 0.0, 0.3};
    for (std::int64_t i = 0; i < 8; ++i) {
      graph.ids.push_back(100 - 10 * chain - i);  // not in the order of ids
      graph.guess.push_back(at);
      at = at * Pose2{3.0, 0.4, 0.2};
    }
  }
  const Eigen::Matrix3d information = Eigen::Vector3d(900.0, 400.0, 2500.0).asDiagonal();
  for (std::int32_t i = 0; i + 1 < 16; ++i) {
    if (i == 7) continue;
    graph.edges.push_back({i, i + 1, EdgeKind::odometry, {3.0, 0.4, 0.2}, information, 0.0});
  }
  return graph;
}

PoseEdge between(const PoseGraph& graph, std::int32_t from, std::int32_t to) {
  Eigen::Matrix3d root;
  root << 30.0, 2.0, 0.0, 1.0, 20.0, 5.0, 0.0, 3.0, 60.0;
  const auto at = [&](std::int32_t node) { return graph.guess[static_cast<std::size_t>(node)]; };
  return {from, to, EdgeKind::loop, inverse(at(from)) * at(to), root.transpose() * root, 0.0};
}

/// The second route: solved anew with the edges in the graph.
LargestVariance solved_with(PoseGraph graph, const std::vector<PoseEdge>& edges) {
  graph.edges.insert(graph.edges.end(), edges.begin(), edges.end());
  OptimizeOptions options;
  options.covariance = true;
  LargestVariance largest;
  for (const Eigen::Matrix3d& of_node : optimize(graph, options).covariance.of_node) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(of_node.topLeftCorner<2, 2>());
    largest.position_m2 = std::max(largest.position_m2, axes.eigenvalues()[1]);
    largest.heading_rad2 = std::max(largest.heading_rad2, of_node(2, 2));
  }
  return largest;
}

void expect_same(const LargestVariance& found, const LargestVariance& expected) {
  EXPECT_NEAR(found.position_m2, expected.position_m2, 1e-6 * expected.position_m2);
  EXPECT_NEAR(found.heading_rad2, expected.heading_rad2, 1e-6 * expected.heading_rad2);
}

class WithHeadings : public testing::TestWithParam<bool> {
 protected:
  [[nodiscard]] static PoseGraph graph() {
    PoseGraph graph = two_chains();
    if (GetParam()) {
      graph.headings.push_back({5, graph.guess[5].theta_rad, radians(2.0), false, 0.0});
    }
    return graph;
  }
};
INSTANTIATE_TEST_SUITE_P(OrWithout, WithHeadings, testing::Bool());

TEST_P(WithHeadings, ToldAheadIsWhatASolveWithTheEdgesFinds) {
  const PoseGraph graph = WithHeadings::graph();
  const AddedEdges added(graph);
  ASSERT_TRUE(added.is_held());
  expect_same(added.now(), solved_with(graph, {}));
  const std::vector<std::vector<PoseEdge>> trials = {
      {between(graph, 0, 7)},
      {between(graph, 3, 4)},
      {between(graph, 15, 9), between(graph, 2, 6), between(graph, 6, 7)}};
  for (const auto& edges : trials) expect_same(added.with(edges), solved_with(graph, edges));
}

TEST_P(WithHeadings, WhatWasAddedCountsForWhatFollows) {
  const PoseGraph graph = WithHeadings::graph();
  AddedEdges added(graph);
  added.add(std::vector{between(graph, 0, 7), between(graph, 8, 12)});
  expect_same(added.now(), solved_with(graph, {between(graph, 0, 7), between(graph, 8, 12)}));
  expect_same(
      added.with(std::vector{between(graph, 9, 15)}),
      solved_with(graph, {between(graph, 0, 7), between(graph, 8, 12), between(graph, 9, 15)}));
}

TEST_P(WithHeadings, RelativeCovariancesAreThoseOfTheSolve) {
  PoseGraph graph = WithHeadings::graph();
  graph.edges.push_back(between(graph, 1, 6));
  OptimizeOptions options;
  options.covariance = true;
  const Eigen::Matrix3d expected = optimize(graph, options).covariance.of_edge.back();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // from the axes of `from` to those of `to`
  const double theta_rad = graph.guess[6].theta_rad - graph.guess[1].theta_rad;
  turn.topLeftCorner<2, 2>() << std::cos(theta_rad), std::sin(theta_rad), -std::sin(theta_rad),
      std::cos(theta_rad);
  const Eigen::Matrix3d found = AddedEdges(graph).relative(1, 6);
  EXPECT_LT((found - turn * expected * turn.transpose()).norm(), 1e-6 * expected.norm());
}

TEST(AddedEdges, NodesThatNothingHoldsAreSaidToBeSo) {
  PoseGraph graph = two_chains();
  for (PoseEdge& edge : graph.edges) edge.information.setZero();
  EXPECT_FALSE(AddedEdges(graph).is_held());
}

TEST(AddedEdges, AGraphWithoutGuessIsRefused) {
  PoseGraph graph = two_chains();
  graph.guess.clear();
  EXPECT_THROW((void)AddedEdges(graph), std::invalid_argument);
}

/// The end of a chain in many draws, and its beginning, which stays.
struct DrawnChain {
  std::vector<Pose2> at{{1.0, 2.0, 0.7}, {4.0, 3.0, 1.9}};
  std::vector<std::vector<Pose2>> moves{{}, {}};

  DrawnChain() {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    for (int draw = 0; draw < 4000; ++draw) {
      moves[0].emplace_back();
      const double turn_rad = 0.02 * normal(random);
      moves[1].push_back({0.3 * normal(random), 0.1 * normal(random) + 2.0 * turn_rad, turn_rad});
    }
  }
};

TEST(AddedEdges, HoldWhatWasDrawn) {
  const DrawnChain chain;
  const AddedEdges added(chain.at, chain.moves);
  EXPECT_NEAR(std::sqrt(added.now().position_m2), 0.3, 0.01);
  EXPECT_NEAR(std::sqrt(added.now().heading_rad2), 0.02, 0.001);
  // in the frame of the end, as it was drawn there
  const Eigen::Matrix3d of_end = added.relative(0, 1);
  EXPECT_NEAR(std::sqrt(of_end(0, 0)), 0.3, 0.01);
  EXPECT_NEAR(std::sqrt(of_end(1, 1)), std::hypot(0.1, 0.04), 0.005);
  EXPECT_NEAR(of_end(1, 2), 2.0 * 0.02 * 0.02, 1e-4);
}

TEST(AddedEdges, ADrawnNodeThatIsMeasuredIsWhatBothSay) {
  const DrawnChain chain;
  AddedEdges added(chain.at, chain.moves);
  PoseEdge edge{0,
                1,
                EdgeKind::loop,
                inverse(chain.at[0]) * chain.at[1],
                Eigen::Vector3d(100.0, 100.0, 1e4).asDiagonal(),
                0.0};
  // draws weighed by what the measurement says of them
  Eigen::Matrix3d weighed = Eigen::Matrix3d::Zero();
  double weights = 0.0;
  for (const Pose2& move : chain.moves[1]) {
    const Eigen::Vector3d off(move.x_m, move.y_m, move.theta_rad);
    const double weight = std::exp(-off.dot(edge.information * off) / 2.0);
    weighed += weight * off * off.transpose();
    weights += weight;
  }
  weighed /= weights;
  added.add({&edge, 1});
  const Eigen::Matrix3d found = added.relative(0, 1);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(std::sqrt(found(i, i) / weighed(i, i)), 1.0, 0.1) << i;
  }
}

TEST(AddedEdges, RefuseMovesThatAreNotOfEveryNode) {
  DrawnChain chain;
  chain.moves[0].pop_back();
  EXPECT_THROW(AddedEdges(chain.at, chain.moves), std::invalid_argument);
  EXPECT_THROW(AddedEdges(chain.at, {}), std::invalid_argument);
}

}  // namespace
}  // namespace roomatlas
