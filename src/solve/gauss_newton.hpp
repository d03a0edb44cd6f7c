// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "linearise.hpp"

namespace roomatlas {

struct GaussNewtonResult {
  SlotPoses state;           ///< the best that was met
  double chi_square = -1.0;  ///< weighted, at `state`; negative = nothing could be evaluated
  int iterations = 0;        ///< linear systems solved
  bool converged = false;
  std::int32_t singular_slot = -1;  ///< where the matrix was not positive definite
};

/// Matrix, factor and workspace for one structure: used again by every solve on it.
class GaussNewton {
 public:
  explicit GaussNewton(const SolverGraph& graph);

  /// Iterates from a start and keeps the best state: steps that go uphill are taken too, because
  /// refusing them costs many iterations and they rarely matter.
  /// @param source of the first step: `measured` for a start of headings without positions
  /// @param tolerance stops when what is left to gain is estimated below this share of chi-square
  [[nodiscard]] GaussNewtonResult solve(SlotPoses state, std::span<const double> weights,
                                        StepSource source, double tolerance = 1e-7,
                                        int max_iterations = 50);

  /// Leaves the factor at a state in `matrix()`. False where it is not positive definite.
  [[nodiscard]] bool factorize_at(const SlotPoses& state, std::span<const double> weights);

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
