// SPDX-License-Identifier: GPL-3.0-or-later
#include "closure_distance.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "covariance.hpp"
#include "index.hpp"
#include "whitening.hpp"

namespace roomatlas {
namespace {

/// Share of a measurement's variance that must be left after the fit. An accepted edge that the
/// others hardly check would have none.
constexpr double kLeastShare = 1e-6;
constexpr double kLeastDeterminant = 1e-300;  // that has a logarithm

/// The error in the frame of `from`, as SolverEdge has it.
Eigen::Vector3d error_of(const SolverEdge& edge, const SlotPoses& state) {
  const double* const a = state.data() + std::ptrdiff_t{edge.from} * 3;
  const double* const b = state.data() + std::ptrdiff_t{edge.to} * 3;
  const Pose2 step = inverse(Pose2{a[0], a[1], a[2]}) * Pose2{b[0], b[1], b[2]};
  return {step.x_m - edge.x_m, step.y_m - edge.y_m, wrap_angle(b[2] - a[2] - edge.theta_rad)};
}

Eigen::Matrix3d information_of(const SolverEdge& edge) {
  const double* const o = edge.information;
  Eigen::Matrix3d information;
  information << o[0], o[1], o[3], o[1], o[2], o[4], o[3], o[4], o[5];
  return information;
}

ClosureTest test(const SolverEdge& edge, const SlotPoses& state, const SelectedInverse& inverse,
                 bool accepted) {
  const Eigen::Matrix3d information = information_of(edge);
  const Eigen::Matrix3d w = whitening(information);
  const Eigen::Vector3d error = w * error_of(edge, state);
  const Eigen::Matrix3d predicted = w * inverse.relative(state, edge.from, edge.to) * w.transpose();
  // Among the accepted, the edge took part in the prediction: what is left of its own variance is
  // that of its residual, and the distance is the same as if it had not (Cook and Weisberg 1982).
  const Eigen::Matrix3d variance = accepted
                                       ? Eigen::Matrix3d(Eigen::Matrix3d::Identity() - predicted)
                                       : Eigen::Matrix3d(Eigen::Matrix3d::Identity() + predicted);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(variance);
  const Eigen::Vector3d values = eigen.eigenvalues().cwiseMax(kLeastShare);
  ClosureTest result;
  result.distance =
      ((eigen.eigenvectors().transpose() * error).array().square() / values.array()).sum();
  const double spread = values.array().log().sum();
  result.log_volume = 0.5 * ((accepted ? -spread : spread) -
                             std::log(std::max(information.determinant(), kLeastDeterminant)));
  return result;
}

}  // namespace

std::vector<ClosureTest> test_closures(const PoseGraph& poses, LeastSquares& squares,
                                       const SlotPoses& state, std::span<const double> weights) {
  std::vector<ClosureTest> tests;
  if (!squares.block_solver().factorize_at(state, weights)) return tests;
  const SelectedInverse inverse(squares.block_solver().matrix());
  const SolverGraph& graph = squares.graph();
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (poses.edges[at(graph.edge_index[e])].kind != EdgeKind::loop) continue;
    tests.push_back(test(graph.edges[e], state, inverse, weights[e] > 0.0));
    tests.back().edge = static_cast<std::int32_t>(e);
  }
  return tests;
}

}  // namespace roomatlas
