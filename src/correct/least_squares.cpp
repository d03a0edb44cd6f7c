// SPDX-License-Identifier: GPL-3.0-or-later
#include "least_squares.hpp"

#include <algorithm>
#include <cmath>

#include "ceres_solver.hpp"
#include "chordal.hpp"

namespace roomatlas {
namespace {

constexpr std::size_t at(std::int64_t index) { return static_cast<std::size_t>(index); }

/// Share of chi-square that may be left to gain.
constexpr double kTolerance = 1e-7;
/// Chi-square a degree of freedom of a guess that is near the minimum.
constexpr double kGood = 1.0;

/// Takes over a solution that is better; iterations add up.
void keep_better(Solved& best, Solved&& other) {
  const int iterations = best.iterations + other.iterations;
  if (!other.state.empty() &&
      (best.state.empty() || other.chi_square < best.chi_square * (1.0 - 1e-9))) {
    best = std::move(other);
  }
  best.iterations = iterations;
}

}  // namespace

LeastSquares::LeastSquares(const PoseGraph& poses, const OptimizeOptions& options)
    : poses_(poses),
      options_(options),
      graph_(solver_graph_of(poses)),
      incidence_(incidence_of(graph_)) {
  block_.emplace(graph_);
}

Solved LeastSquares::by_block(const State& start, std::span<const double> weights,
                              StepSource source, int max_iterations) {
  GaussNewtonResult result = block_->solve(start, weights, source, kTolerance, max_iterations);
  Solved solved{
      std::move(result.state),       result.chi_square, result.iterations, result.converged, -1,
      "block Cholesky, Gauss-Newton"};
  if (result.singular_slot != -1) {
    const auto node = std::ranges::find(graph_.slot, result.singular_slot);
    solved.singular_node = static_cast<std::int32_t>(node - graph_.slot.begin());
  }
  if (!solved.converged) solved.message += " did not converge";
  return solved;
}

/// From the best state so far; kept when it is better.
void LeastSquares::continue_with_ceres(Solved& solved, const State& start,
                                       std::span<const double> weights) {
  const TrustRegion region =
      options_.solver == PoseGraphSolver::ceres ? TrustRegion::none : TrustRegion::damped;
  CeresResult ceres = solve_with_ceres(graph_, poses_, solved.state.empty() ? start : solved.state,
                                       weights, region, options_.max_iterations);
  solved.iterations += ceres.iterations;
  if (!solved.state.empty() && !(ceres.chi_square <= solved.chi_square)) return;
  solved.state = std::move(ceres.state);
  solved.chi_square = ceres.chi_square;
  solved.converged = ceres.converged;
  solved.message = "Ceres: " + ceres.message;
}

Solved LeastSquares::local(const State& start, std::span<const double> weights, StepSource source) {
  const bool ceres = options_.solver == PoseGraphSolver::ceres;
  Solved solved;
  // Ceres needs positions too: headings alone get them with the first step.
  if (!ceres || source == StepSource::measured) {
    solved = by_block(start, weights, source, ceres ? 1 : options_.max_iterations);
  }
  if (ceres || !solved.converged) {
    continue_with_ceres(solved, source == StepSource::measured ? odometry() : start, weights);
  }
  return solved;
}

/// A guess that fits this well needs no global start. Whether it winds right is checked after.
bool LeastSquares::is_good(const State& guess, std::span<const double> weights) const {
  const double freedom =
      3.0 * (static_cast<double>(graph_.edges.size()) - static_cast<double>(graph_.variable_count));
  return freedom > 0.0 && weights.empty() && chi_square(graph_, guess, weights) < kGood * freedom;
}

Solved LeastSquares::solve(std::span<const double> weights) {
  const State guess = poses_.guess.empty() ? State() : state_of(poses_.guess);
  const bool from_guess = !guess.empty() && is_good(guess, weights);
  const State start = from_guess ? guess : chordal_headings(graph_, weights);
  if (start.empty()) return solve_from(odometry(), weights);
  Solved best = local(start, weights, from_guess ? StepSource::state : StepSource::measured);
  const SpanningTree tree = spanning_tree(graph_, incidence_, {}, weights);
  if (best.converged && winds_right(graph_, tree, best.state, weights)) return best;

  const State by_winding = headings_by_winding(graph_, tree, weights);
  const State other = from_guess ? chordal_headings(graph_, weights) : guess;
  if (!by_winding.empty()) {
    keep_better(best, local(by_winding, weights, StepSource::measured));
  }
  if (!other.empty()) {
    keep_better(best, local(other, weights, from_guess ? StepSource::measured : StepSource::state));
  }
  keep_better(best, local(odometry(), weights, StepSource::state));
  return best;
}

Solved LeastSquares::solve_from(const State& start, std::span<const double> weights) {
  return local(start, weights, StepSource::state);
}

SpanningTree LeastSquares::odometry_tree() const {
  std::vector<std::uint8_t> costly(graph_.edges.size());
  for (std::size_t e = 0; e < costly.size(); ++e) {
    costly[e] = poses_.edges[at(graph_.edge_index[e])].kind == EdgeKind::loop ? 1 : 0;
  }
  return spanning_tree(graph_, incidence_, costly, {});
}

State LeastSquares::odometry() const { return poses_along(graph_, odometry_tree()); }

std::vector<std::int32_t> LeastSquares::bridges() const {
  std::vector<std::int32_t> loops;
  for (const std::int32_t e : odometry_tree().via) {
    if (e == -1) continue;
    if (poses_.edges[at(graph_.edge_index[at(e)])].kind == EdgeKind::loop) loops.push_back(e);
  }
  return loops;
}

State LeastSquares::state_of(const std::vector<Pose2>& poses) const {
  State state(poses.size() * 3);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::int32_t fixed = graph_.components.fixed[at(graph_.components.component[i])];
    const Pose2 pose = inverse(poses[at(fixed)]) * poses[i];
    double* const p = state.data() + std::ptrdiff_t{graph_.slot[i]} * 3;
    p[0] = pose.x_m;
    p[1] = pose.y_m;
    p[2] = pose.theta_rad;
  }
  return state;
}

std::vector<Pose2> LeastSquares::poses_of(const State& state) const {
  std::vector<Pose2> poses(graph_.slot.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::int32_t fixed = graph_.components.fixed[at(graph_.components.component[i])];
    const double* const p = state.data() + std::ptrdiff_t{graph_.slot[i]} * 3;
    const Pose2 pose{p[0], p[1], p[2]};
    poses[i] = poses_.guess.empty() ? pose : poses_.guess[at(fixed)] * pose;
  }
  return poses;
}

}  // namespace roomatlas
