// SPDX-License-Identifier: GPL-3.0-or-later
// Robust losses and measured headings in the solver of pose graphs: against numeric derivatives,
// against a problem that is given to Ceres as it stands, and between the two solvers.
#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <limits>

#include "../../src/solve/linearise.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/solve/optimize.hpp"
#include "solve/shuffled.hpp"
#include "support/numeric_derivative.hpp"

namespace roomatlas {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kSigma = radians(2.0);

/// Loops under Cauchy's loss, one in ten of them false; headings, some of them wrong, at every
/// other node. The guess is the truth with some noise.
struct Chain {
  test::GeneratedGraph g;
  explicit Chain(std::uint64_t seed, bool quarters = false, std::int32_t nodes = 60)
      : g(test::walk_graph(nodes, 0.05, 0.03, seed)) {
    g.graph = test::with_false_loops(g.graph, 0.1, test::FalseLoops::single, seed);
    for (PoseEdge& edge : g.graph.edges) {
      if (edge.kind == EdgeKind::loop) edge.cauchy_sigmas = 2.0;
    }
    test::Dice dice(seed);
    for (std::int32_t i = 1; i < nodes; i += 2) {
      const double off = dice.uniform() < 0.1 ? radians(25.0) : kSigma * dice.normal();
      const double turned = quarters ? kPi / 2.0 * dice.below(4) : 0.0;
      const double theta = g.truth[static_cast<std::size_t>(i)].theta_rad + off + turned;
      g.graph.headings.push_back({i, wrap_angle(theta), kSigma, quarters, 2.0});
    }
    for (const Pose2& pose : g.truth) {
      const Pose2 noise{0.1 * dice.normal(), 0.1 * dice.normal(), 0.1 * dice.normal()};
      g.graph.guess.push_back(pose * noise);
    }
  }
};

struct EdgeError {
  const PoseEdge& edge;
  Matrix3d root;
  template <typename T>
  bool operator()(const T* a, const T* b, T* residual) const {
    const Pose2& m = edge.from_from_to;
    const T c = cos(a[2] + m.theta_rad);
    const T s = sin(a[2] + m.theta_rad);
    const T dx = b[0] - a[0] - (cos(a[2]) * m.x_m - sin(a[2]) * m.y_m);
    const T dy = b[1] - a[1] - (sin(a[2]) * m.x_m + cos(a[2]) * m.y_m);
    const T turn = b[2] - a[2] - m.theta_rad;
    const Eigen::Matrix<T, 3, 1> error(c * dx + s * dy, c * dy - s * dx,
                                       atan2(sin(turn), cos(turn)));
    Eigen::Map<Eigen::Matrix<T, 3, 1>> result(residual);
    result = root.cast<T>() * error;
    return true;
  }
};

struct HeadingError {
  double theta_rad;
  template <typename T>
  bool operator()(const T* pose, T* residual) const {
    const T off = pose[2] - theta_rad;
    residual[0] = atan2(sin(off), cos(off)) / kSigma;
    return true;
  }
};

/// Ceres by itself: automatic derivatives, its own losses, Levenberg-Marquardt to the end.
std::vector<Pose2> by_plain_ceres(const PoseGraph& graph, std::vector<Pose2> poses) {
  std::vector<Eigen::Vector3d> blocks;
  for (const Pose2& p : poses) blocks.emplace_back(p.x_m, p.y_m, p.theta_rad);
  const auto block = [&](std::int32_t i) { return blocks[static_cast<std::size_t>(i)].data(); };
  const auto loss = [](double scale) {
    return scale > 0.0 ? new ceres::CauchyLoss(scale) : nullptr;
  };
  ceres::Problem problem;
  for (const PoseEdge& edge : graph.edges) {
    using Cost = ceres::AutoDiffCostFunction<EdgeError, 3, 3, 3>;
    problem.AddResidualBlock(new Cost(new EdgeError{edge, edge.information.llt().matrixU()}),
                             loss(edge.cauchy_sigmas), block(edge.from), block(edge.to));
  }
  for (const HeadingPrior& prior : graph.headings) {
    using Cost = ceres::AutoDiffCostFunction<HeadingError, 1, 3>;
    problem.AddResidualBlock(new Cost(new HeadingError{prior.theta_rad}), loss(prior.cauchy_sigmas),
                             block(prior.node));
  }
  if (graph.headings.empty()) {
    problem.SetParameterBlockConstant(block(0));
  } else {
    problem.SetManifold(block(0), new ceres::SubsetManifold(3, {0, 1}));
  }
  ceres::Solver::Options options;
  options.max_num_iterations = 500;
  options.function_tolerance = 1e-15;
  options.parameter_tolerance = 1e-14;
  options.gradient_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  for (std::size_t i = 0; i < poses.size(); ++i)
    poses[i] = {blocks[i](0), blocks[i](1), blocks[i](2)};
  return poses;
}

double largest_distance_m(const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, (a[i].position() - b[i].position()).norm());
  }
  return largest;
}

TEST(LossesAndHeadings, TheRightSideIsTheNumericGradient) {
  const PoseGraph graph = Chain(1).g.graph;
  const SolverGraph solver = solver_graph_of(graph);
  test::Dice dice(3);
  VectorXd x(static_cast<Eigen::Index>(graph.ids.size() * 3));
  for (double& value : x) value = dice.normal();
  const Eigen::Index root = solver.roots[0] * 3;
  x.segment<2>(root).setZero();  // as it stays: the anchor has no error there
  const auto cost = [&](const VectorXd& at) {
    return VectorXd(VectorXd::Constant(1, chi_square(solver, {at.begin(), at.end()}, {})));
  };
  VectorXd expected = -0.5 * test::numeric_jacobian(cost, x).transpose();
  std::vector<double> right_side;
  const double now = gradient(solver, {x.begin(), x.end()}, {}, right_side);
  EXPECT_NEAR(now, cost(x)(0), 1e-12 * now);
  const Eigen::Map<const VectorXd> found(right_side.data(), std::ssize(right_side));
  EXPECT_LT((found - expected).norm(), 1e-6 * expected.norm());
}

TEST(LossesAndHeadings, TheMatrixIsThatOfTheReweightedEquations) {
  const PoseGraph graph = Chain(2).g.graph;
  SolverGraph solver = solver_graph_of(graph);
  test::Dice dice(3);
  SlotPoses state(graph.ids.size() * 3);
  for (double& value : state) value = dice.normal();
  BlockCholesky<3> matrix(solver.supernodes);
  const MatrixPlaces<3> places = places_of(solver, matrix);
  std::vector<double> right_side;
  NormalEquations equations{matrix, places, right_side};
  (void)linearise(solver, state, {}, StepSource::state, equations);
  const std::vector<double> reweighted(matrix.values(),
                                       matrix.values() + 9 * solver.supernodes.panel_begin.back());
  std::vector<double> each;
  (void)chi_square(solver, state, {}, &each);
  std::vector<double> weights;
  for (std::size_t e = 0; e < each.size(); ++e) {
    weights.push_back(cauchy_weight(each[e], solver.edges[e].cauchy_sigmas));
    solver.edges[e].cauchy_sigmas = 0.0;
  }
  for (SolverHeading& heading : solver.headings) {
    heading.information *= cauchy_weight(chi_square(heading, state), heading.cauchy_sigmas);
    heading.cauchy_sigmas = 0.0;
  }
  (void)linearise(solver, state, weights, StepSource::state, equations);
  for (std::size_t k = 0; k < reweighted.size(); ++k) {
    EXPECT_NEAR(matrix.values()[k], reweighted[k], 1e-9 * (1.0 + std::abs(reweighted[k])));
  }
}

TEST(LossesAndHeadings, TheMinimumIsThatOfCeresWithItsOwnCauchyLoss) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Chain f(seed);
    for (const bool headings : {false, true}) {
      if (!headings) f.g.graph.headings.clear();
      const OptimizeResult result = optimize(f.g.graph, {});
      EXPECT_TRUE(result.converged) << result.message;
      EXPECT_NEAR(chi_square(f.g.graph, result.poses), result.chi_square, 1e-9 * result.chi_square);
      const std::vector<Pose2> there = by_plain_ceres(f.g.graph, result.poses);
      const double cost = chi_square(f.g.graph, there);
      EXPECT_NEAR(result.chi_square, cost, 1e-6 * cost) << "seed " << seed;
      EXPECT_LT(largest_distance_m(result.poses, there), 2e-3) << "seed " << seed;
      const double from_guess = chi_square(f.g.graph, by_plain_ceres(f.g.graph, f.g.graph.guess));
      EXPECT_LT(result.chi_square, from_guess * (1.0 + 1e-6)) << "seed " << seed;
    }
  }
}

TEST(LossesAndHeadings, BlocksAndCeresAgree) {
  for (const bool quarters : {false, true}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const PoseGraph graph = Chain(seed, quarters, 200).g.graph;
      OptimizeOptions ceres;
      ceres.solver = PoseGraphSolver::ceres;
      const OptimizeResult a = optimize(graph, {});
      const OptimizeResult b = optimize(graph, ceres);
      EXPECT_NEAR(a.chi_square, b.chi_square, 1e-6 * a.chi_square);
      EXPECT_LT(largest_distance_m(a.poses, b.poses), 3e-3);
      ASSERT_EQ(a.headings.size(), b.headings.size());
      for (std::size_t k = 0; k < a.headings.size(); ++k) {
        EXPECT_NEAR(a.headings[k].weight, b.headings[k].weight, 1e-2);
        EXPECT_NEAR(a.headings[k].theta_rad, b.headings[k].theta_rad, 1e-12);
      }
    }
  }
}

TEST(LossesAndHeadings, TheAnswerIsTheSameForShuffledInput) {
  const PoseGraph graph = Chain(5, true, 200).g.graph;
  const OptimizeResult expected = optimize(graph, {});
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const PoseGraph other = test::shuffled(graph, seed);
    const OptimizeResult result = optimize(other, {});
    EXPECT_NEAR(result.chi_square, expected.chi_square, 1e-6 * expected.chi_square);
    for (std::size_t k = 0; k < other.ids.size(); ++k) {
      const Pose2& same = expected.poses[static_cast<std::size_t>(other.ids[k])];
      EXPECT_LT((result.poses[k].position() - same.position()).norm(), 3e-3);
    }
  }
}

TEST(Losses, AFalseLoopLosesItsWeightAndSaysSo) {
  Chain f(3);
  f.g.graph.headings.clear();
  const OptimizeResult result = optimize(f.g.graph, {});
  const EdgeVerdict& odometry = result.edges.front();
  EXPECT_EQ(odometry.weight, 1.0);
  EXPECT_EQ(odometry.reason, EdgeReason::least_squares);
  const EdgeVerdict& wrong = result.edges.back();
  EXPECT_LT(wrong.weight, 0.01);
  EXPECT_EQ(wrong.reason, EdgeReason::reweighted);
  EXPECT_NEAR(wrong.weight, 1.0 / (1.0 + wrong.chi_square / 4.0), 1e-9);
  EXPECT_THAT(words(wrong), HasSubstr("counts with weight"));
}

TEST(Headings, TurnAComponentAsAWholeAboutItsFixedNode) {
  PoseGraph graph = test::ring_graph(30, 1e-6, 1e-6, 1).graph;
  graph.headings.push_back({7, 1.0, 0.1, false, 0.0});
  graph.guess.assign(30, {5.0, -3.0, 0.7});
  const OptimizeResult result = optimize(graph, {});
  EXPECT_NEAR(result.poses[7].theta_rad, 1.0, 1e-6);
  EXPECT_NEAR(result.poses[0].x_m, 5.0, 1e-9);
  EXPECT_NEAR(result.poses[0].y_m, -3.0, 1e-9);
  EXPECT_LT(result.chi_square, 100.0);
  EXPECT_EQ(result.expected.degrees_of_freedom, 3 * 30 + 1 - (3 * 30 - 2));
}

TEST(Headings, OfOneComponentLeaveTheOthersAlone) {
  PoseGraph graph = test::ring_graph(20, 0.02, 0.02, 1).graph;
  const PoseGraph other = test::ring_graph(20, 0.02, 0.02, 2).graph;
  for (PoseEdge edge : other.edges) {
    edge.from += 20;
    edge.to += 20;
    graph.edges.push_back(edge);
  }
  for (std::int64_t id = 20; id < 40; ++id) graph.ids.push_back(id);
  const std::vector<Pose2> plain = optimize(graph, {}).poses;
  graph.headings.push_back({25, -2.0, 0.1, false, 0.0});
  const std::vector<Pose2> turned = optimize(graph, {}).poses;
  EXPECT_NEAR(turned[25].theta_rad, -2.0, 1e-6);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_LT((plain[i].position() - turned[i].position()).norm(), 1e-3);
  }
}

TEST(Headings, QuarterTurnsAreSettledAtTheGuessOrByTheEdges) {
  Chain f(4, true, 150);
  const PoseGraph& graph = f.g.graph;
  for (const bool with_guess : {true, false}) {
    PoseGraph input = graph;
    if (!with_guess) input.guess.clear();
    const OptimizeResult result = optimize(input, {});
    EXPECT_LT(test::aligned_rmse_m(result.poses, f.g.truth), 0.15);
    std::size_t near = 0;
    for (const HeadingVerdict& heading : result.headings) near += heading.weight > 0.3 ? 1 : 0;
    EXPECT_GT(near * 10, result.headings.size() * 7);
  }
}

TEST(Headings, CovariancesAreBlocksOfTheDenseInverse) {
  PoseGraph graph = test::walk_graph(25, 0.05, 0.03, 3).graph;
  for (std::int32_t i = 2; i < 25; i += 5) graph.headings.push_back({i, 0.2 * i, 0.05, false, 0.0});
  OptimizeOptions options;
  options.covariance = true;
  const OptimizeResult result = optimize(graph, options);
  VectorXd state(75);
  for (Eigen::Index i = 0; i < 25; ++i) {
    const Pose2& p = result.poses[static_cast<std::size_t>(i)];
    state.segment<3>(i * 3) << p.x_m, p.y_m, p.theta_rad;
  }
  const auto pose = [](const VectorXd& x, Eigen::Index i) {
    return Pose2{x(i * 3), x(i * 3 + 1), x(i * 3 + 2)};
  };
  const auto whitened = [&](const VectorXd& x) {
    const auto edges = std::ssize(graph.edges);
    VectorXd all(edges * 3 + std::ssize(graph.headings));
    for (Eigen::Index e = 0; e < edges; ++e) {
      const PoseEdge& edge = graph.edges[static_cast<std::size_t>(e)];
      const Matrix3d root = edge.information.llt().matrixU();
      all.segment<3>(e * 3) = root * edge_error(edge, pose(x, edge.from), pose(x, edge.to));
    }
    for (Eigen::Index k = 0; k < std::ssize(graph.headings); ++k) {
      const HeadingPrior& prior = graph.headings[static_cast<std::size_t>(k)];
      all(edges * 3 + k) = wrap_angle(x(prior.node * 3 + 2) - prior.theta_rad) / prior.sigma_rad;
    }
    return all;
  };
  const MatrixXd jacobian = test::numeric_jacobian(whitened, state).rightCols(73);
  const MatrixXd covariance = (jacobian.transpose() * jacobian).inverse();
  EXPECT_NEAR(result.covariance.of_node[0](2, 2), covariance(0, 0), 1e-4 * covariance(0, 0));
  for (Eigen::Index i = 1; i < 25; ++i) {
    const Matrix3d expected = covariance.block<3, 3>(i * 3 - 2, i * 3 - 2);
    const auto& found = result.covariance.of_node[static_cast<std::size_t>(i)];
    EXPECT_LT((found - expected).norm(), 1e-4 * expected.norm());
  }
}

TEST(LossesAndHeadings, ThatMakeNoSenseAreRefused) {
  const PoseGraph good = Chain(1).g.graph;
  const auto expect_refused = [](const PoseGraph& graph, const std::string& mentions) {
    EXPECT_THAT([&] { (void)optimize(graph, {}); }, ThrowsMessage<InputError>(HasSubstr(mentions)));
  };
  PoseGraph graph = good;
  graph.edges[4].cauchy_sigmas = -1.0;
  expect_refused(graph, "from 4 to 5: the scale of its loss");
  graph = good;
  graph.headings[1].node = 60;
  expect_refused(graph, "heading number 2: its node is not there");
  graph = good;
  graph.headings[1].sigma_rad = 0.0;
  expect_refused(graph, "not a positive number");
  graph = good;
  graph.headings[1].theta_rad = std::numeric_limits<double>::quiet_NaN();
  expect_refused(graph, "not finite");
  graph = good;
  graph.headings[1].cauchy_sigmas = std::numeric_limits<double>::infinity();
  expect_refused(graph, "scale of its loss");
}

}  // namespace
}  // namespace roomatlas
