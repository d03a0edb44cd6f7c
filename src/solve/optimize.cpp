// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/solve/optimize.hpp"

#include <algorithm>

#include "covariance.hpp"
#include "index.hpp"
#include "judge.hpp"
#include "least_squares.hpp"
#include "robust.hpp"

namespace roomatlas {
namespace {

/// Poses, figures and verdicts of the solution.
void fill(const PoseGraph& graph, const LeastSquares& squares, const Solved& solved,
          std::span<const double> weights, OptimizeResult& result) {
  const SolverGraph& g = squares.graph();
  result.poses = squares.poses_of(solved.state);
  result.converged = solved.converged;
  result.message = solved.message;
  result.chi_square = solved.chi_square;
  result.iterations = solved.iterations;
  result.expected = expected_chi_square(g, weights);
  std::vector<double> each;
  (void)chi_square(g, solved.state, {}, &each);
  result.edges.resize(graph.edges.size());
  for (std::size_t e = 0; e < each.size(); ++e) {
    EdgeVerdict& verdict = result.edges[at(g.edge_index[e])];
    const double weight = weights.empty() ? 1.0 : weights[e];
    verdict.weight = weight * cauchy_weight(each[e], g.edges[e].cauchy_sigmas);
    verdict.accepted = weight > 0.0;
    verdict.chi_square = each[e];
  }
  for (const SolverHeading& heading : g.headings) {
    const double off = chi_square(heading, solved.state);
    result.headings.push_back({cauchy_weight(off, heading.cauchy_sigmas), off, heading.theta_rad});
  }
}

void give_reasons(const PoseGraph& graph, bool robust, OptimizeResult& result) {
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    EdgeVerdict& verdict = result.edges[e];
    const bool has_loss = graph.edges[e].cauchy_sigmas > 0.0;
    verdict.reason = !robust ? has_loss ? EdgeReason::reweighted : EdgeReason::least_squares
                     : graph.edges[e].kind != EdgeKind::loop ? EdgeReason::never_rejected
                     : verdict.accepted                      ? EdgeReason::fits
                                                             : EdgeReason::contradicts;
  }
}

}  // namespace

OptimizeResult optimize(const PoseGraph& graph, const OptimizeOptions& options) {
  check(graph);
  if (graph.edges.empty()) {
    const std::size_t count = graph.ids.size();
    throw NotEnoughError("the pose graph has " + std::to_string(count) +
                         (count == 1 ? " node" : " nodes") +
                         " and no edge: there is nothing to solve");
  }
  LeastSquares squares(graph, options);
  OptimizeResult result;
  result.component = squares.graph().components.component;
  result.fixed = squares.graph().components.fixed;
  result.initial_chi_square = squares.initial_chi_square();
  RobustSolution robust;
  if (options.robust) {
    robust = solve_robustly(graph, squares);
  } else {
    robust.solved = squares.solve({});
  }
  fill(graph, squares, robust.solved, robust.weights, result);
  give_reasons(graph, options.robust, result);
  result.issues = std::move(robust.issues);
  judge(graph, robust.solved, result);
  result.trusted = std::ranges::none_of(
      result.issues, [](const Issue& issue) { return issue.severity != Severity::note; });
  if (options.covariance) {
    result.covariance = covariance_of(graph, squares, robust.solved.state, robust.weights);
  }
  return result;
}

}  // namespace roomatlas
