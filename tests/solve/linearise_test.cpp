// SPDX-License-Identifier: GPL-3.0-or-later
// Cost, gradient and matrix of the solver against g2o's formula written out and its numeric
// derivatives.
#include "../../src/solve/linearise.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "roomatlas/correct/place.hpp"
#include "support/generated_pose_graph.hpp"
#include "support/numeric_derivative.hpp"

namespace roomatlas {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Strongly correlated information, measurements far from the poses, edges both ways.
PoseGraph crooked_graph() {
  PoseGraph graph = test::walk_graph(14, 0.3, 0.4, 4).graph;
  test::Dice dice(2);
  for (PoseEdge& edge : graph.edges) {
    Eigen::Matrix3d root;
    for (double& value : root.reshaped()) value = dice.normal();
    edge.information = root * root.transpose() + 0.1 * Eigen::Matrix3d::Identity();
    if (dice.uniform() < 0.5) std::swap(edge.from, edge.to);
  }
  return graph;
}

/// [ R_ij' (R_i' (t_j - t_i) - t_ij) ; wrap(...) ], with rotations as matrices.
Vector3d literal_error(const PoseEdge& edge, const Vector3d& i, const Vector3d& j) {
  const Eigen::Rotation2Dd r_i(i(2));
  const Eigen::Rotation2Dd r_ij(edge.from_from_to.theta_rad);
  const Vector2d t_ij(edge.from_from_to.x_m, edge.from_from_to.y_m);
  const Vector2d t = r_ij.inverse() * (r_i.inverse() * Vector2d((j - i).head<2>()) - t_ij);
  const double turn = j(2) - i(2) - edge.from_from_to.theta_rad;
  return {t.x(), t.y(), std::atan2(std::sin(turn), std::cos(turn))};
}

struct Fixture {
  PoseGraph graph = crooked_graph();
  SolverGraph solver = solver_graph_of(graph);
  VectorXd state;
  Fixture() {
    test::Dice dice(8);
    state.resize(static_cast<Eigen::Index>(graph.ids.size() * 3));
    for (double& value : state) value = 2.0 * dice.normal();
    for (Eigen::Index k = 2; k < state.size(); k += 3) state(k) = wrap_angle(state(k));
  }
  [[nodiscard]] Vector3d at(const VectorXd& x, std::int32_t node) const {
    return x.segment<3>(solver.slot[static_cast<std::size_t>(node)] * 3);
  }
  [[nodiscard]] VectorXd whitened(const VectorXd& x) const {
    VectorXd all(static_cast<Eigen::Index>(graph.edges.size() * 3));
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      const PoseEdge& edge = graph.edges[e];
      const Eigen::Matrix3d root = edge.information.llt().matrixU();
      all.segment<3>(static_cast<Eigen::Index>(e * 3)) =
          root * literal_error(edge, at(x, edge.from), at(x, edge.to));
    }
    return all;
  }
  [[nodiscard]] SlotPoses as_state() const { return {state.data(), state.data() + state.size()}; }
};

TEST(Linearise, ChiSquareIsTheLiteralFormula) {
  const Fixture f;
  const double expected = f.whitened(f.state).squaredNorm();
  EXPECT_NEAR(chi_square(f.solver, f.as_state(), {}), expected, 1e-10 * expected);
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < f.graph.ids.size(); ++i) {
    const Vector3d p = f.at(f.state, static_cast<std::int32_t>(i));
    poses.push_back({p(0), p(1), p(2)});
  }
  EXPECT_NEAR(chi_square(f.graph, poses), expected, 1e-10 * expected);
}

TEST(Linearise, MatrixAndRightSideAreThoseOfNumericDerivatives) {
  const Fixture f;
  BlockCholesky<3> matrix(f.solver.supernodes);
  const MatrixPlaces<3> places = places_of(f.solver, matrix);
  std::vector<double> right_side;
  NormalEquations equations{matrix, places, right_side};
  const double cost = linearise(f.solver, f.as_state(), {}, StepSource::state, equations);
  EXPECT_NEAR(cost, f.whitened(f.state).squaredNorm(), 1e-9 * cost);

  const Eigen::Index size = f.solver.variable_count * 3;
  const MatrixXd all =
      test::numeric_jacobian([&](const VectorXd& x) { return f.whitened(x); }, f.state);
  const MatrixXd jacobian = all.leftCols(size);  // fixed nodes stand at the end
  const VectorXd expected = -jacobian.transpose() * f.whitened(f.state);
  const Eigen::Map<const VectorXd> found(right_side.data(), size);
  EXPECT_LT((found - expected).norm(), 1e-6 * expected.norm());
  std::vector<double> alone;
  (void)gradient(f.solver, f.as_state(), {}, alone);
  EXPECT_EQ(alone, right_side);

  const MatrixXd dense = jacobian.transpose() * jacobian;
  for (const SolverEdge& edge : f.solver.edges) {
    if (std::max(edge.from, edge.to) >= f.solver.variable_count) continue;
    for (const auto& [row, column] :
         {std::pair{std::max(edge.from, edge.to), std::min(edge.from, edge.to)},
          {edge.from, edge.from},
          {edge.to, edge.to}}) {
      const BlockPlace place = matrix.place(row, column);
      for (int j = 0; j < 3; ++j) {
        for (int i = row == column ? j : 0; i < 3; ++i) {
          const double value = matrix.values()[place.offset + i + j * place.stride];
          EXPECT_NEAR(value, dense(row * 3 + i, column * 3 + j), 1e-5 * dense.norm());
        }
      }
    }
  }
}

TEST(Linearise, AWeightScalesItsEdgeAndZeroLeavesItOut) {
  const Fixture f;
  std::vector<double> weights(f.graph.edges.size(), 0.0);
  weights[5] = 2.5;
  std::vector<double> each;
  const double sum = chi_square(f.solver, f.as_state(), weights, &each);
  EXPECT_NEAR(sum, 2.5 * each[5], 1e-12 * sum);
}

}  // namespace
}  // namespace roomatlas
