// SPDX-License-Identifier: GPL-3.0-or-later
#include "ceres_model.hpp"

#include <ceres/solver.h>

namespace roomatlas {
namespace {

constexpr double kSettledShare = 1e-9;  // of the cost; larger ends before small falls are taken

}  // namespace

double chi_square(const ceres::Problem& problem, const ReportedFactor& factor) {
  double half_chi_square = 0.0;
  problem.EvaluateResidualBlock(factor.block, false, &half_chi_square, nullptr, nullptr);
  return 2.0 * half_chi_square;
}

void solve(ceres::Problem& problem, std::vector<ReportedFactor>& factors,
           const CorrectOptions& options, ModelResult& result) {
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  solver.max_num_iterations = options.max_iterations;
  solver.function_tolerance = kSettledShare;
  solver.num_threads = 1;  // the sum's order, and with it the last bits, must not change
  solver.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);

  result.converged = summary.termination_type == ceres::CONVERGENCE;
  result.message = summary.message;
  result.initial_cost = summary.initial_cost;
  result.final_cost = summary.final_cost;
  result.iterations = static_cast<int>(summary.iterations.size());
  for (ReportedFactor& factor : factors) {
    FactorReport& report = factor.report;
    report.chi_square_after = chi_square(problem, factor);
    const double squared_scale = options.robust_sigmas * options.robust_sigmas;
    report.weight = factor.is_robust ? 1.0 / (1.0 + report.chi_square_after / squared_scale) : 1.0;
    result.factors.push_back(report);
  }
}

FactorReport report_of(const Measurements& measurements, const Measurements::Edge& edge,
                       FactorKind kind) {
  FactorReport report;
  report.kind = kind;
  report.from = measurements.ids[edge.from];
  report.to = measurements.ids[edge.to];
  return report;
}

}  // namespace roomatlas
