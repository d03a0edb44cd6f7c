// SPDX-License-Identifier: GPL-3.0-or-later
#include "least_squares.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ceres_solver.hpp"
#include "chordal.hpp"
#include "heading_priors.hpp"
#include "index.hpp"
#include "joint_relaxation.hpp"

namespace roomatlas {
namespace {

/// Share of chi-square that may be left to gain.
constexpr double kTolerance = 1e-7;
/// Share of chi-square by which two solutions of the same minimum may differ.
constexpr double kSameMinimum = 2e-5;
/// Chi-square a degree of freedom of a guess that is near the minimum.
constexpr double kGood = 1.0;
/// Share of chi-square that a better solution gains at least: less is rounding.
constexpr double kBetter = 1e-9;
/// Weights of positions against headings in further global starts: each errs elsewhere.
constexpr std::array kPositionShares = {0.1, 10.0};

/// Takes over a solution that is better; iterations add up.
void keep_better(Solved& best, Solved&& other) {
  const int iterations = best.iterations + other.iterations;
  if (!other.state.empty() &&
      (best.state.empty() || other.chi_square < best.chi_square * (1.0 - kBetter))) {
    other.other_minimum = best.other_minimum;
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
  const auto has_loss = [](const auto& measured) { return measured.cauchy_sigmas > 0.0; };
  has_losses_ =
      std::ranges::any_of(graph_.edges, has_loss) || std::ranges::any_of(graph_.headings, has_loss);
  find_frames();
  if (!poses.guess.empty()) guess_ = state_of(poses.guess);
  if (!graph_.headings.empty()) settle_headings();
  initial_chi_square_ = chi_square(graph_, guess_.empty() ? odometry() : guess_, {});
}

/// Decides which quarter turns the measured headings mean.
void LeastSquares::settle_headings() {
  if (!guess_.empty()) return settle_quarters(poses_, guess_, graph_);
  SlotPoses start = options_.robust ? SlotPoses() : chordal_headings(graph_, {}, false);
  if (start.empty()) start = poses_along(graph_, odometry_tree());
  turn_to_quarters(poses_, graph_, start);
  settle_quarters(poses_, start, graph_);
}

Solved LeastSquares::by_block(const SlotPoses& start, std::span<const double> weights,
                              StepSource source, int max_iterations) {
  GaussNewtonResult result = block_->solve(start, weights, source, kTolerance, max_iterations);
  Solved solved{std::move(result.state),
                result.chi_square,
                result.iterations,
                result.converged,
                -1,
                -1.0,
                "block Cholesky, Gauss-Newton"};
  if (result.singular_slot != -1) {
    const auto node = std::ranges::find(graph_.slot, result.singular_slot);
    solved.singular_node = static_cast<std::int32_t>(node - graph_.slot.begin());
  }
  if (!solved.converged) solved.message += " did not converge";
  return solved;
}

/// From the best state so far; kept when it is better.
void LeastSquares::continue_with_ceres(Solved& solved, const SlotPoses& start,
                                       std::span<const double> weights) {
  const TrustRegion region = options_.solver == PoseGraphSolver::ceres && !has_losses_
                                 ? TrustRegion::none
                                 : TrustRegion::damped;
  CeresResult ceres = solve_with_ceres(graph_, poses_, solved.state.empty() ? start : solved.state,
                                       weights, region, options_.max_iterations);
  solved.iterations += ceres.iterations;
  if (!solved.state.empty() && !(ceres.chi_square <= solved.chi_square)) return;
  solved.state = std::move(ceres.state);
  solved.chi_square = ceres.chi_square;
  solved.converged = ceres.converged;
  solved.message = "Ceres: " + ceres.message;
}

Solved LeastSquares::local(const SlotPoses& start, std::span<const double> weights,
                           StepSource source) {
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
bool LeastSquares::is_good(double chi_square, std::span<const double> weights) const {
  const double freedom =
      3.0 * (static_cast<double>(graph_.edges.size()) - static_cast<double>(graph_.variable_count));
  return freedom > 0.0 && weights.empty() && chi_square < kGood * freedom;
}

/// Losses leave many minima. The guess's own valley is that of one who knows more than the edges
/// say; the global start finds the one in which most closures hold.
Solved LeastSquares::solve_with_losses(std::span<const double> weights) {
  Solved best = solve_from(guess_.empty() ? odometry() : guess_, weights);
  const SpanningTree tree = spanning_tree(graph_, incidence_, {}, weights);
  if (best.converged && is_good(best.chi_square, weights) &&
      winds_right(graph_, tree, best.state, weights)) {
    return best;
  }
  const SlotPoses global = chordal_headings(graph_, weights);
  if (!global.empty()) keep_better(best, local(global, weights, StepSource::measured));
  return best;
}

Solved LeastSquares::solve(std::span<const double> weights) {
  if (has_losses_) return solve_with_losses(weights);
  const bool from_guess = !guess_.empty() && is_good(initial_chi_square_, weights);
  const SlotPoses start = from_guess ? guess_ : chordal_headings(graph_, weights);
  if (start.empty()) return solve_from(odometry(), weights);
  Solved best = local(start, weights, from_guess ? StepSource::state : StepSource::measured);
  const SpanningTree tree = spanning_tree(graph_, incidence_, {}, weights);
  if (best.converged && winds_right(graph_, tree, best.state, weights)) return best;

  try_more_starts(best, tree, from_guess, weights);
  return best;
}

/// For measurements so noisy that loops may be wound wrongly. Two global starts that know different
/// things, headings alone and all measurements, hardly end in the same wrong minimum; where they
/// part, more are tried and the lowest is doubtful.
void LeastSquares::try_more_starts(Solved& best, const SpanningTree& tree, bool from_guess,
                                   std::span<const double> weights) {
  std::vector<double> ends;
  if (!from_guess) ends.push_back(best.chi_square);
  const auto try_from = [&](const SlotPoses& start, StepSource source) {
    if (start.empty()) return;
    Solved other = local(start, weights, source);
    ends.push_back(other.chi_square);
    keep_better(best, std::move(other));
  };
  const auto all_agree = [&] {
    return std::ranges::all_of(
        ends, [&](double end) { return end <= best.chi_square * (1.0 + kSameMinimum); });
  };
  if (from_guess) try_from(chordal_headings(graph_, weights), StepSource::measured);
  try_from(joint_headings(graph_, weights, 1.0), StepSource::measured);
  if (ends.size() >= 2 && best.converged && all_agree()) return;

  SlotPoses by_winding = headings_by_winding(graph_, tree, weights);
  if (!by_winding.empty()) turn_to_headings(graph_, by_winding);
  try_from(by_winding, StepSource::measured);
  for (const double position_share : kPositionShares) {
    try_from(joint_headings(graph_, weights, position_share), StepSource::measured);
  }
  if (!from_guess) try_from(guess_, StepSource::state);
  try_from(odometry(), StepSource::state);
  best.other_minimum = *std::ranges::max_element(ends);
}

Solved LeastSquares::solve_from(const SlotPoses& start, std::span<const double> weights) {
  return local(start, weights, StepSource::state);
}

SpanningTree LeastSquares::odometry_tree() const {
  std::vector<std::uint8_t> costly(graph_.edges.size());
  for (std::size_t e = 0; e < costly.size(); ++e) {
    costly[e] = poses_.edges[at(graph_.edge_index[e])].kind == EdgeKind::loop ? 1 : 0;
  }
  return spanning_tree(graph_, incidence_, costly, {});
}

SlotPoses LeastSquares::odometry() const {
  SlotPoses state = poses_along(graph_, odometry_tree());
  turn_to_headings(graph_, state);
  return state;
}

std::vector<std::int32_t> LeastSquares::bridges() const {
  std::vector<std::int32_t> loops;
  for (const std::int32_t e : odometry_tree().via) {
    if (e == -1) continue;
    if (poses_.edges[at(graph_.edge_index[at(e)])].kind == EdgeKind::loop) loops.push_back(e);
  }
  return loops;
}

void LeastSquares::find_frames() {
  frames_.resize(graph_.roots.size());
  if (poses_.guess.empty()) return;
  for (std::size_t c = 0; c < frames_.size(); ++c) {
    frames_[c] = poses_.guess[at(graph_.components.fixed[c])];
    if (graph_.roots[c] < graph_.variable_count) frames_[c].theta_rad = 0.0;
  }
}

SlotPoses LeastSquares::state_of(const std::vector<Pose2>& poses) const {
  SlotPoses state(poses.size() * 3);
  std::vector<Pose2> from_poses;
  for (const Pose2& frame : frames_) from_poses.push_back(inverse(frame));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose2 pose = from_poses[at(graph_.components.component[i])] * poses[i];
    double* const p = state.data() + std::ptrdiff_t{graph_.slot[i]} * 3;
    p[0] = pose.x_m;
    p[1] = pose.y_m;
    p[2] = pose.theta_rad;
  }
  return state;
}

std::vector<Pose2> LeastSquares::poses_of(const SlotPoses& state) const {
  std::vector<Pose2> poses(graph_.slot.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double* const p = state.data() + std::ptrdiff_t{graph_.slot[i]} * 3;
    const Pose2 pose{p[0], p[1], p[2]};
    poses[i] = poses_.guess.empty() ? pose : frames_[at(graph_.components.component[i])] * pose;
  }
  return poses;
}

}  // namespace roomatlas
