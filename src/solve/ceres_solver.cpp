// SPDX-License-Identifier: GPL-3.0-or-later
#include "ceres_solver.hpp"

#include <ceres/loss_function.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <deque>

#include "index.hpp"
#include "pose_factors.hpp"

namespace roomatlas {
namespace {

constexpr double kUnboundedRadius = 1e16;  // of the trust region: plain Gauss-Newton steps
constexpr double kSettledShare = 1e-9;     // of the cost; larger falls count as steps to be taken

/// Cost functions by address, losses with them: the problem owns neither.
struct Factors {
  std::deque<RelativePoseFactor> edges;
  std::deque<HeadingFactor> headings;
  std::deque<ceres::CauchyLoss> cauchy;
  std::deque<ceres::ScaledLoss> scaled;

  /// Cauchy's loss times a weight; none at all where there is nothing to change.
  ceres::LossFunction* loss(double cauchy_sigmas, double weight) {
    ceres::LossFunction* result =
        cauchy_sigmas > 0.0 ? &cauchy.emplace_back(cauchy_sigmas) : nullptr;
    if (weight == 1.0) return result;
    return &scaled.emplace_back(result, weight, ceres::DO_NOT_TAKE_OWNERSHIP);
  }
};

void add_headings(const SolverGraph& graph, SlotPoses& state, Factors& factors,
                  ceres::Problem& problem) {
  for (const SolverHeading& heading : graph.headings) {
    factors.headings.emplace_back(heading.theta_rad, 1.0 / std::sqrt(heading.information));
    problem.AddResidualBlock(&factors.headings.back(), factors.loss(heading.cauchy_sigmas, 1.0),
                             state.data() + std::ptrdiff_t{heading.slot} * 3);
  }
  for (const Anchor& anchor : graph.anchors) {
    double* const held = state.data() + std::ptrdiff_t{anchor.slot} * 3;
    problem.AddParameterBlock(held, 3);
    problem.SetManifold(held, new ceres::SubsetManifold(3, {0, 1}));
  }
}

}  // namespace

CeresResult solve_with_ceres(const SolverGraph& graph, const PoseGraph& poses,
                             const SlotPoses& start, std::span<const double> weights,
                             TrustRegion trust_region, int max_iterations) {
  CeresResult result;
  result.state = start;
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  Factors factors;
  ceres::Problem problem(ownership);
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const double weight = weights.empty() ? 1.0 : weights[e];
    if (weight == 0.0) continue;
    const PoseEdge& edge = poses.edges[at(graph.edge_index[e])];
    factors.edges.emplace_back(edge.from_from_to, edge.information);
    problem.AddResidualBlock(&factors.edges.back(), factors.loss(edge.cauchy_sigmas, weight),
                             result.state.data() + std::ptrdiff_t{graph.edges[e].from} * 3,
                             result.state.data() + std::ptrdiff_t{graph.edges[e].to} * 3);
  }
  for (std::size_t k = at(graph.variable_count); k < graph.slot.size(); ++k) {
    double* const fixed = result.state.data() + k * 3;
    if (problem.HasParameterBlock(fixed)) problem.SetParameterBlockConstant(fixed);
  }
  add_headings(graph, result.state, factors, problem);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  if (trust_region == TrustRegion::none) {
    options.initial_trust_region_radius = kUnboundedRadius;
    options.max_trust_region_radius = kUnboundedRadius;
    options.jacobi_scaling = false;
  }
  options.function_tolerance = kSettledShare;
  options.max_num_iterations = max_iterations;
  options.num_threads = 1;  // the order of sums must not change
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  for (std::size_t k = 2; k < result.state.size(); k += 3) {
    result.state[k] = wrap_angle(result.state[k]);
  }
  result.chi_square = chi_square(graph, result.state, weights);
  result.iterations = static_cast<int>(summary.iterations.size());
  result.converged = summary.termination_type == ceres::CONVERGENCE;
  result.message = summary.message;
  return result;
}

}  // namespace roomatlas
