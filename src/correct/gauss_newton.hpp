// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "linearise.hpp"

namespace roomatlas {

struct GaussNewtonResult {
  State state;               ///< the best that was met
  double chi_square = -1.0;  ///< weighted, at `state`; negative = nothing could be evaluated
  int iterations = 0;        ///< linear systems solved
  bool converged = false;
  std::int32_t singular_slot = -1;  ///< where the matrix was not positive definite
};

/// Matrix, factor and workspace for one structure: used again by every solve on it.
class GaussNewton {
 public:
  explicit GaussNewton(const SolverGraph& graph);
  ~GaussNewton();

  /// Iterates from a start and keeps the best state: steps that go uphill are taken too, because
  /// refusing them costs many iterations and they rarely matter.
  /// @param source of the first step: `measured` for a start of headings without positions
  /// @param tolerance stops when the predicted fall of chi-square is below this share of it
  [[nodiscard]] GaussNewtonResult solve(State start, std::span<const double> weights,
                                        StepSource source, double tolerance = 1e-8,
                                        int max_iterations = 50);

  [[nodiscard]] BlockCholesky<3>& matrix() { return matrix_; }
  [[nodiscard]] const MatrixPlaces<3>& places() const { return places_; }

 private:
  const SolverGraph& graph_;
  BlockCholesky<3> matrix_;
  MatrixPlaces<3> places_;
  std::vector<double> right_side_;
  std::vector<double> step_;
};

}  // namespace roomatlas
