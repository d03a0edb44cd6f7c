// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/solve/optimize.hpp"

#include <algorithm>
#include <cmath>

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

bool is_finite(const Pose2& pose) {
  return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.theta_rad);
}

bool is_finite(const OptimizeResult& result) {
  const auto& covariance = result.covariance;
  const auto all_finite = [](const Eigen::Matrix3d& matrix) { return matrix.allFinite(); };
  return std::isfinite(result.initial_chi_square) && std::isfinite(result.chi_square) &&
         std::ranges::all_of(result.poses, [](const Pose2& pose) { return is_finite(pose); }) &&
         std::ranges::all_of(result.edges,
                             [](const EdgeVerdict& v) { return std::isfinite(v.chi_square); }) &&
         std::ranges::all_of(covariance.of_node, all_finite) &&
         std::ranges::all_of(covariance.of_edge, all_finite);
}

/// The part of the graph that has the largest number, in words.
std::string largest_of(const PoseGraph& graph) {
  std::string named;
  double largest = -1.0;
  const auto take = [&](double value, const auto& words) {
    if (!(value > largest)) return;
    largest = value;
    named = words();
  };
  for (const PoseEdge& edge : graph.edges) {
    const double value = std::max({std::abs(edge.from_from_to.x_m), std::abs(edge.from_from_to.y_m),
                                   edge.information.cwiseAbs().maxCoeff()});
    take(value, [&] {
      return "the edge from " + std::to_string(graph.ids[at(edge.from)]) + " to " +
             std::to_string(graph.ids[at(edge.to)]);
    });
  }
  for (std::size_t i = 0; i < graph.guess.size(); ++i) {
    take(std::max(std::abs(graph.guess[i].x_m), std::abs(graph.guess[i].y_m)),
         [&] { return "vertex " + std::to_string(graph.ids[i]); });
  }
  return named;
}

/// Numbers that are none are no result.
void require_finite(const PoseGraph& graph, const OptimizeResult& result) {
  if (is_finite(result)) return;
  throw NotEnoughError(
      "the pose graph has no solution in finite numbers, so none is written: is a column of it "
      "damaged? The largest number has " +
      largest_of(graph) + "; expected are metres, radians and their information");
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
  require_finite(graph, result);
  return result;
}

}  // namespace roomatlas
