// SPDX-License-Identifier: GPL-3.0-or-later
#include "gauss_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

/// A solution by an old factor is tried when the last fall of chi-square was below this share.
constexpr double kNearlyThere = 1e-4;
/// Share of chi-square that a step may promise for its promise to be trusted.
constexpr double kShortStep = 1e-2;
constexpr int kMostUphillSteps = 6;  // in all; then it goes nowhere
/// An old factor goes on serving while each step promises less than this share of the one before.
constexpr double kFallsFast = 0.1;
constexpr double kSlowestFall = 0.9;  // steps that shrink by less: nine times the last gain is left
constexpr double kExactEdge = 1e-12;  // chi-square an edge that is rounding, not a misfit

/// Adds the step. @return the fall of chi-square that the linear model predicts
double take(const std::vector<double>& step, const std::vector<double>& right_side,
            SlotPoses& state) {
  double predicted = 0.0;
  for (std::size_t i = 0; i < step.size(); ++i) {
    state[i] += step[i];
    predicted += step[i] * right_side[i];
  }
  for (std::size_t i = 2; i < step.size(); i += 3) state[i] = wrap_angle(state[i]);
  return predicted;
}

/// Chi-square that would still be gained after a step, if steps go on shrinking as they did.
double left_after(double predicted, double predicted_before) {
  if (!std::isfinite(predicted)) return std::numeric_limits<double>::infinity();
  const double ratio = std::clamp(predicted / predicted_before, 0.0, kSlowestFall);
  return std::isfinite(predicted_before) ? predicted * ratio / (1.0 - ratio) : predicted;
}

/// Keeps the best state and says whether to go on.
class Best {
 public:
  explicit Best(GaussNewtonResult& result) : result_(result) {
    result_.chi_square = std::numeric_limits<double>::infinity();
  }
  bool offer(double chi_square, const SlotPoses& state) {
    if (chi_square <= result_.chi_square) {
      result_.chi_square = chi_square;
      result_.state = state;
      return true;
    }
    return std::isfinite(chi_square) && ++uphill_ <= kMostUphillSteps;
  }

 private:
  GaussNewtonResult& result_;
  int uphill_ = 0;
};

}  // namespace

GaussNewton::GaussNewton(const SolverGraph& graph)
    : graph_(graph), matrix_(graph.supernodes), places_(places_of(graph, matrix_)) {}

GaussNewtonResult GaussNewton::solve(SlotPoses state, std::span<const double> weights,
                                     StepSource source, double tolerance, int max_iterations) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const double floor = kExactEdge * static_cast<double>(graph_.edges.size());
  GaussNewtonResult result;
  Best best(result);
  NormalEquations equations{matrix_, places_, right_side_};
  bool old_factor = false;
  double left = kUnknown;
  double predicted = kUnknown;
  double expected = kUnknown;  // chi-square, by the last linear model
  for (;;) {
    const bool done = std::isfinite(left) && left <= tolerance * result.chi_square + floor;
    const bool last = done || result.iterations >= max_iterations;
    const double now = last         ? chi_square(graph_, state, weights)
                       : old_factor ? gradient(graph_, state, weights, right_side_)
                                    : linearise(graph_, state, weights, source, equations);
    if (source == StepSource::state && !best.offer(now, state)) return result;
    const bool as_expected = std::abs(now - expected) <= tolerance * now + floor;
    if (last || as_expected) {
      result.converged = done || as_expected;
      return result;
    }
    if (!old_factor) {
      result.singular_slot = matrix_.factorize();
      if (result.singular_slot != -1) return result;
    }
    step_ = right_side_;
    matrix_.solve(step_.data());
    const double before = predicted;
    predicted = take(step_, right_side_, state);
    ++result.iterations;
    if (source == StepSource::measured) {  // its prediction is that of another problem
      predicted = kUnknown;
      source = StepSource::state;
      continue;
    }
    left = left_after(predicted, before);
    // Where the model holds to within the tolerance, what it leaves out is not worth a step either.
    // A long step may hit what it expected by chance.
    expected = predicted < kShortStep * now ? now - predicted : kUnknown;
    old_factor = predicted < kNearlyThere * now && (!old_factor || predicted < kFallsFast * before);
  }
}

bool GaussNewton::factorize_at(const SlotPoses& state, std::span<const double> weights) {
  NormalEquations equations{matrix_, places_, right_side_};
  (void)linearise(graph_, state, weights, StepSource::state, equations);
  return matrix_.factorize() == -1;
}

}  // namespace roomatlas
