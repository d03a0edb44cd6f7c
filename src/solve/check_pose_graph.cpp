// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/solve/pose_graph.hpp"

namespace roomatlas {
namespace {

constexpr double kRounding = 1e-9;  ///< relative, of the numbers in a file

bool is_finite(const Pose2& pose) {
  return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.theta_rad);
}

/// What is wrong with an information matrix, or empty.
std::string wrong_with(const Eigen::Matrix3d& information) {
  if (!information.allFinite()) return "the information matrix has a number that is not finite";
  const double largest = information.cwiseAbs().maxCoeff();
  if (!information.isApprox(information.transpose(), kRounding) && largest > 0.0) {
    return "the information matrix is not symmetric";
  }
  if (information.determinant() > 0.0 && information(0, 0) > 0.0 &&
      information.topLeftCorner<2, 2>().determinant() > 0.0) {
    return {};
  }
  // Scaled to a unit diagonal, so that metres and radians cannot hide each other.
  Eigen::Vector3d scale = information.diagonal().cwiseAbs().cwiseSqrt();
  for (double& s : scale) s = s > 0.0 ? 1.0 / s : 1.0;
  const Eigen::Matrix3d scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scaled, Eigen::EigenvaluesOnly);
  if (solver.eigenvalues().minCoeff() >= -kRounding) return {};
  return "the information matrix has a negative eigenvalue: it is not the inverse of a covariance";
}

std::string wrong_with(const PoseGraph& graph, const PoseEdge& edge) {
  const auto count = static_cast<std::int32_t>(graph.ids.size());
  if (edge.from < 0 || edge.from >= count || edge.to < 0 || edge.to >= count) {
    return "joins a node that is not there";
  }
  if (edge.from == edge.to) return "joins a node with itself";
  return problem_of(edge);
}

std::string wrong_with(const PoseGraph& graph, const HeadingPrior& prior) {
  if (prior.node < 0 || prior.node >= static_cast<std::int32_t>(graph.ids.size())) {
    return "its node is not there";
  }
  if (!std::isfinite(prior.theta_rad)) return "it is not finite";
  if (!(prior.sigma_rad > 0.0) || !std::isfinite(prior.sigma_rad)) {
    return "its standard deviation is not a positive number";
  }
  return prior.cauchy_sigmas >= 0.0 && std::isfinite(prior.cauchy_sigmas)
             ? ""
             : "the scale of its loss is negative or not finite";
}

}  // namespace

std::string problem_of(const PoseEdge& edge) {
  if (!is_finite(edge.from_from_to)) return "the measured pose has a number that is not finite";
  if (!(edge.cauchy_sigmas >= 0.0) || !std::isfinite(edge.cauchy_sigmas)) {
    return "the scale of its loss is negative or not finite";
  }
  return wrong_with(edge.information);
}

void check(const PoseGraph& graph) {
  std::vector<std::int64_t> ids = graph.ids;
  if (!std::ranges::is_sorted(ids)) std::ranges::sort(ids);
  if (const auto twice = std::ranges::adjacent_find(ids); twice != ids.end()) {
    throw InputError("node " + std::to_string(*twice) + " is there twice; ids must be unique");
  }
  if (!graph.guess.empty() && graph.guess.size() != graph.ids.size()) {
    throw InputError("the graph has " + std::to_string(graph.ids.size()) + " nodes but " +
                     std::to_string(graph.guess.size()) + " guessed poses; give all or none");
  }
  for (std::size_t i = 0; i < graph.guess.size(); ++i) {
    if (!is_finite(graph.guess[i])) {
      throw InputError("node " + std::to_string(graph.ids[i]) +
                       ": the guessed pose has a number that is not finite");
    }
  }
  for (std::size_t k = 0; k < graph.headings.size(); ++k) {
    const std::string wrong = wrong_with(graph, graph.headings[k]);
    if (wrong.empty()) continue;
    throw InputError("measured heading number " + std::to_string(k + 1) + ": " + wrong);
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const PoseEdge& edge = graph.edges[e];
    const std::string wrong = wrong_with(graph, edge);
    if (wrong.empty()) continue;
    const auto id = [&](std::int32_t node) {
      return node >= 0 && node < static_cast<std::int32_t>(graph.ids.size())
                 ? std::to_string(graph.ids[static_cast<std::size_t>(node)])
                 : "(index " + std::to_string(node) + ")";
    };
    throw InputError("edge number " + std::to_string(e + 1) + " from " + id(edge.from) + " to " +
                     id(edge.to) + ": " + wrong);
  }
}

}  // namespace roomatlas
