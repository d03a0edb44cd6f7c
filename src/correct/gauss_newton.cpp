// SPDX-License-Identifier: GPL-3.0-or-later
#include "gauss_newton.hpp"

#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

/// A solution by an old factor is tried when the last fall of chi-square was below this share.
constexpr double kNearlyThere = 1e-4;
constexpr int kMostUphillSteps = 6;

/// Adds the step. @return the fall of chi-square that the linear model predicts
double take(const std::vector<double>& step, const std::vector<double>& right_side, State& state) {
  double predicted = 0.0;
  for (std::size_t i = 0; i < step.size(); ++i) {
    state[i] += step[i];
    predicted += step[i] * right_side[i];
  }
  for (std::size_t i = 2; i < step.size(); i += 3) state[i] = wrap_angle(state[i]);
  return predicted;
}

}  // namespace

GaussNewton::GaussNewton(const SolverGraph& graph)
    : graph_(graph), matrix_(graph.supernodes), places_(places_of(graph, matrix_)) {}

GaussNewton::~GaussNewton() = default;

GaussNewtonResult GaussNewton::solve(State state, std::span<const double> weights,
                                     StepSource source, double tolerance, int max_iterations) {
  GaussNewtonResult best;
  best.chi_square = std::numeric_limits<double>::infinity();
  NormalEquations equations{matrix_, places_, right_side_};
  int uphill = 0;
  bool old_factor = false;
  double predicted = std::numeric_limits<double>::infinity();
  for (int k = 0;; ++k) {
    double now = 0.0;
    const bool last = (std::isfinite(predicted) && predicted <= tolerance * best.chi_square) ||
                      k == max_iterations;
    if (last) {
      now = chi_square(graph_, state, weights);
    } else if (old_factor) {
      now = gradient(graph_, state, weights, right_side_);
    } else {
      now = linearise(graph_, state, weights, source, equations);
    }
    if (source == StepSource::state) {
      if (now <= best.chi_square) {
        best.chi_square = now;
        best.state = state;
      } else if (!(std::abs(now) <= std::numeric_limits<double>::max()) ||
                 ++uphill > kMostUphillSteps) {
        return best;
      }
    }
    if (last) {
      best.converged = k < max_iterations;
      return best;
    }
    if (!old_factor) {
      if (const std::int32_t failed = matrix_.factorize(); failed != -1) {
        best.singular_slot = failed;
        return best;
      }
    }
    step_ = right_side_;
    matrix_.solve(step_.data());
    const double before = predicted;
    predicted = take(step_, right_side_, state);
    ++best.iterations;
    old_factor = source == StepSource::state && predicted < kNearlyThere * now &&
                 (!old_factor || predicted < 0.1 * before);
    if (source == StepSource::measured) predicted = std::numeric_limits<double>::infinity();
    source = StepSource::state;
  }
}

}  // namespace roomatlas
