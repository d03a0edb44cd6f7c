// SPDX-License-Identifier: GPL-3.0-or-later
#include "ceres_solver.hpp"

#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/Eigenvalues>
#include <deque>

#include "factors.hpp"

namespace roomatlas {
namespace {

constexpr std::size_t at(std::int64_t index) { return static_cast<std::size_t>(index); }

}  // namespace

CeresResult solve_with_ceres(const SolverGraph& graph, const PoseGraph& poses, const State& start,
                             std::span<const double> weights, TrustRegion trust_region,
                             int max_iterations) {
  CeresResult result;
  result.state = start;
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  std::deque<RelativePoseFactor> factors;  // in one place, and addresses stay
  ceres::Problem problem(ownership);
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const double weight = weights.empty() ? 1.0 : weights[e];
    if (weight == 0.0) continue;
    const PoseEdge& edge = poses.edges[at(graph.edge_index[e])];
    factors.emplace_back(edge.from_from_to, weight * edge.information);
    problem.AddResidualBlock(&factors.back(), nullptr,
                             result.state.data() + std::ptrdiff_t{graph.edges[e].from} * 3,
                             result.state.data() + std::ptrdiff_t{graph.edges[e].to} * 3);
  }
  for (std::size_t k = at(graph.variable_count); k < graph.slot.size(); ++k) {
    double* const fixed = result.state.data() + k * 3;
    if (problem.HasParameterBlock(fixed)) problem.SetParameterBlockConstant(fixed);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  if (trust_region == TrustRegion::none) {
    options.initial_trust_region_radius = 1e16;
    options.max_trust_region_radius = 1e16;
    options.jacobi_scaling = false;
  }
  options.function_tolerance = 1e-9;
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
