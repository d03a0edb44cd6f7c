// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/solve/optimize.hpp"
#include "roomatlas/core/issue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solve/shuffled.hpp"
#include "support/generated_pose_graph.hpp"
#include "support/numeric_derivative.hpp"

namespace roomatlas {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using test::shuffled;

TEST(Optimize, FindsTheTruthWhereThereIsNoNoise) {
  const test::GeneratedGraph g = test::walk_graph(300, 1e-9, 1e-9, 1);
  const OptimizeResult result = optimize(g.graph, {});
  EXPECT_LT(test::aligned_rmse_m(result.poses, g.truth), 1e-6);
  EXPECT_TRUE(result.converged);
}

TEST(Optimize, AnswersTheSameForShuffledInput) {
  const test::GeneratedGraph g = test::room_graph(400, 3);
  const OptimizeResult expected = optimize(g.graph, {});
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const PoseGraph other = shuffled(g.graph, seed);
    const OptimizeResult result = optimize(other, {});
    EXPECT_NEAR(result.chi_square, expected.chi_square, 1e-6 * expected.chi_square);
    for (std::size_t k = 0; k < other.ids.size(); ++k) {
      const Pose2& same = expected.poses[static_cast<std::size_t>(other.ids[k])];
      EXPECT_LT((result.poses[k].position() - same.position()).norm(), 1e-3);
    }
  }
}

TEST(Optimize, BlocksAndCeresAgree) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const PoseGraph graph = test::room_graph(225, seed).graph;
    OptimizeOptions ceres;
    ceres.solver = PoseGraphSolver::ceres;
    const OptimizeResult a = optimize(graph, {});
    const OptimizeResult b = optimize(graph, ceres);
    EXPECT_NEAR(a.chi_square, b.chi_square, 1e-6 * a.chi_square);
    EXPECT_THAT(b.message, HasSubstr("Ceres"));
    EXPECT_LT(test::aligned_rmse_m(a.poses, b.poses), 1e-3);
  }
}

TEST(Optimize, AGuessDoesNotMatterHoweverWrong) {
  test::GeneratedGraph g = test::walk_graph(200, 0.05, 0.05, 5);
  const double without = optimize(g.graph, {}).chi_square;
  test::Dice dice(1);
  for (std::size_t i = 0; i < g.truth.size(); ++i) {
    g.graph.guess.push_back({30.0 * dice.normal(), 30.0 * dice.normal(), 3.0 * dice.normal()});
  }
  EXPECT_NEAR(optimize(g.graph, {}).chi_square, without, 1e-5 * without);
  g.graph.guess = g.truth;
  EXPECT_NEAR(optimize(g.graph, {}).chi_square, without, 1e-5 * without);
}

TEST(Optimize, NeverEndsAboveTheMinimumNearTheTruth) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {  // rotation noise of 11 degrees a step
    test::GeneratedGraph g = test::walk_graph(250, 0.1, 0.2, seed);
    const double found = optimize(g.graph, {}).chi_square;
    g.graph.guess = g.truth;
    const double near_truth = optimize(g.graph, {}).chi_square;
    EXPECT_LT(found, near_truth * (1.0 + 1e-5)) << "seed " << seed;
  }
}

TEST(Optimize, ARingThatOdometryWindsWronglyIsWoundRight) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    test::GeneratedGraph g = test::ring_graph(300, 0.05, 0.05, seed);
    const double found = optimize(g.graph, {}).chi_square;
    double wound = 0.0;  // the guess takes the ring round once more: a local minimum
    for (std::size_t i = 0; i < g.truth.size(); ++i) {
      wound = 2.0 * kPi * static_cast<double>(i) / 300.0;
      g.graph.guess.push_back(
          {g.truth[i].x_m, g.truth[i].y_m, wrap_angle(g.truth[i].theta_rad + wound)});
    }
    EXPECT_NEAR(optimize(g.graph, {}).chi_square, found, 1e-5 * found);
  }
}

TEST(Optimize, InformationMaySpreadOverTenOrders) {
  PoseGraph graph = test::walk_graph(150, 0.05, 0.02, 2).graph;
  test::Dice dice(6);
  for (PoseEdge& edge : graph.edges) {
    edge.information *= std::pow(10.0, 10.0 * dice.uniform() - 5.0);
  }
  OptimizeOptions ceres;
  ceres.solver = PoseGraphSolver::ceres;
  const OptimizeResult result = optimize(graph, {});
  EXPECT_TRUE(result.converged) << result.message;
  EXPECT_NEAR(result.chi_square, optimize(graph, ceres).chi_square, 1e-4 * result.chi_square);
}

TEST(Optimize, EachComponentHasItsOwnFixedNodeThatKeepsItsGuess) {
  PoseGraph graph = test::walk_graph(40, 0.02, 0.02, 1).graph;
  const PoseGraph other = test::ring_graph(30, 0.02, 0.02, 2).graph;
  for (const PoseEdge& edge : other.edges) {
    graph.edges.push_back(edge);
    graph.edges.back().from += 40;
    graph.edges.back().to += 40;
  }
  for (std::int64_t id = 0; id < 30; ++id) graph.ids.push_back(100 + id);
  graph.guess.assign(70, {5.0, -3.0, 0.7});
  const OptimizeResult result = optimize(graph, {});
  EXPECT_EQ(result.fixed, (std::vector<std::int32_t>{0, 40}));
  EXPECT_EQ(result.poses[0], (Pose2{5.0, -3.0, 0.7}));
  EXPECT_EQ(result.poses[40], (Pose2{5.0, -3.0, 0.7}));
  EXPECT_EQ(result.component[69], 1);
  EXPECT_TRUE(result.trusted);
  ASSERT_FALSE(result.issues.empty());
  EXPECT_THAT(to_string(result.issues.front()), HasSubstr("each is solved by itself"));
  EXPECT_TRUE(result.converged);
}

TEST(Optimize, CovariancesAreBlocksOfTheDenseInverse) {
  const PoseGraph graph = test::walk_graph(25, 0.05, 0.03, 3).graph;
  OptimizeOptions options;
  options.covariance = true;
  const OptimizeResult result = optimize(graph, options);
  Eigen::VectorXd state(75);
  for (Eigen::Index i = 0; i < 25; ++i) {
    const Pose2& p = result.poses[static_cast<std::size_t>(i)];
    state.segment<3>(i * 3) << p.x_m, p.y_m, p.theta_rad;
  }
  const auto pose = [](const Eigen::VectorXd& x, Eigen::Index i) {
    return Pose2{x(i * 3), x(i * 3 + 1), x(i * 3 + 2)};
  };
  const auto whitened = [&](const Eigen::VectorXd& x) {
    Eigen::VectorXd all(static_cast<Eigen::Index>(graph.edges.size() * 3));
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      const PoseEdge& edge = graph.edges[e];
      const Eigen::Matrix3d root = edge.information.llt().matrixU();
      all.segment<3>(static_cast<Eigen::Index>(e * 3)) =
          root * edge_error(edge, pose(x, edge.from), pose(x, edge.to));
    }
    return all;
  };
  const Eigen::MatrixXd jacobian = test::numeric_jacobian(whitened, state).rightCols(72);
  const Eigen::MatrixXd covariance = (jacobian.transpose() * jacobian).inverse();
  EXPECT_TRUE(result.covariance.of_node[0].isZero());
  for (Eigen::Index i = 1; i < 25; ++i) {
    const Eigen::Matrix3d expected = covariance.block<3, 3>((i - 1) * 3, (i - 1) * 3);
    const auto& found = result.covariance.of_node[static_cast<std::size_t>(i)];
    EXPECT_LT((found - expected).norm(), 1e-4 * expected.norm());
  }
  const PoseEdge& last = graph.edges.back();
  ASSERT_GT(last.from, 0);
  const auto step = [&](const Eigen::VectorXd& x) {
    const Pose2 between = inverse(pose(x, last.from)) * pose(x, last.to);
    return Eigen::VectorXd(Eigen::Vector3d(between.x_m, between.y_m, between.theta_rad));
  };
  const Eigen::MatrixXd by_state = test::numeric_jacobian(step, state).rightCols(72);
  const Eigen::Matrix3d expected = by_state * covariance * by_state.transpose();
  EXPECT_LT((result.covariance.of_edge.back() - expected).norm(), 1e-4 * expected.norm());
}

TEST(Judgement, ChiSquareOfHonestNoiseIsInItsRange) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const OptimizeResult result = optimize(test::room_graph(900, seed).graph, {});
    EXPECT_GT(result.chi_square, result.expected.low);
    EXPECT_LT(result.chi_square, result.expected.high);
    EXPECT_TRUE(result.trusted);
    EXPECT_TRUE(result.issues.empty());
  }
}

TEST(Judgement, AMinimumThatMayNotBeTheLowestIsSaidLoudly) {
  int wrong = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {  // headings say next to nothing
    test::GeneratedGraph g = test::walk_graph(250, 0.1, 0.5, seed);
    const OptimizeResult result = optimize(g.graph, {});
    g.graph.guess = g.truth;
    const double near_truth = optimize(g.graph, {}).chi_square;
    if (result.chi_square < near_truth * (1.0 + 1e-4)) continue;
    ++wrong;
    EXPECT_FALSE(result.trusted) << "seed " << seed;
    EXPECT_THAT(to_string(result.issues.front()), HasSubstr("may not be the lowest"));
  }
  EXPECT_LE(wrong, 4);
}

TEST(Judgement, NoiseThatLeavesNoDoubtGivesNoWarning) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    EXPECT_TRUE(optimize(test::walk_graph(250, 0.1, 0.2, seed).graph, {}).trusted);
    EXPECT_TRUE(optimize(test::ring_graph(400, 0.05, 0.1, seed).graph, {}).trusted);
  }
}

TEST(Judgement, WithoutRobustEstimationAFalseLoopIsSaidLoudly) {
  const PoseGraph clean = test::walk_graph(200, 0.02, 0.02, 4).graph;
  const PoseGraph graph = test::with_false_loops(clean, 0.02, test::FalseLoops::single, 1);
  ASSERT_GT(graph.edges.size(), clean.edges.size());
  const OptimizeResult result = optimize(graph, {});
  EXPECT_FALSE(result.trusted);
  ASSERT_FALSE(result.issues.empty());
  EXPECT_THAT(to_string(result.issues.back()), HasSubstr("--robust"));
}

TEST(Judgement, ANodeThatNothingHoldsIsNamed) {
  PoseGraph graph = test::ring_graph(10, 0.02, 0.02, 1).graph;
  graph.ids.push_back(77);
  PoseEdge loose;
  loose.from = 3;
  loose.to = 10;
  loose.information = Eigen::Vector3d(100.0, 100.0, 0.0).asDiagonal();
  graph.edges.push_back(loose);
  const OptimizeResult result = optimize(graph, {});
  EXPECT_FALSE(result.trusted);
  const auto names = [](const Issue& issue) {
    return to_string(issue).find("node 77") != std::string::npos;
  };
  EXPECT_TRUE(std::ranges::any_of(result.issues, names));
}

TEST(WrongGraphs, AreRefusedWithTheirPlace) {
  const PoseGraph good = test::ring_graph(10, 0.02, 0.02, 1).graph;
  const auto expect_refused = [](const PoseGraph& graph, const std::string& mentions) {
    EXPECT_THAT([&] { (void)optimize(graph, {}); }, ThrowsMessage<InputError>(HasSubstr(mentions)));
  };
  PoseGraph graph = good;
  graph.edges[4].from_from_to.x_m = std::numeric_limits<double>::quiet_NaN();
  expect_refused(graph, "from 4 to 5: the measured pose");
  graph = good;
  graph.edges[4].information(2, 2) = -1.0;
  expect_refused(graph, "negative eigenvalue");
  graph = good;
  graph.edges[4].information(0, 1) = 5.0;
  expect_refused(graph, "not symmetric");
  graph = good;
  graph.ids[3] = 7;
  expect_refused(graph, "node 7 is there twice");
  graph = good;
  graph.edges[2].to = 99;
  expect_refused(graph, "not there");
  graph = good;
  graph.edges[2].to = graph.edges[2].from;
  expect_refused(graph, "with itself");
  graph = good;
  graph.guess.resize(3);
  expect_refused(graph, "guessed poses");
}

TEST(WrongGraphs, WithoutAnEdgeThereIsNothingToSolve) {
  EXPECT_THROW((void)optimize({}, {}), NotEnoughError);
  EXPECT_THROW((void)optimize({{5}, {}, {}}, {}), NotEnoughError);
}

}  // namespace
}  // namespace roomatlas
