// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "linearise.hpp"

namespace roomatlas {

struct CeresResult {
  SlotPoses state;
  double chi_square = -1.0;  ///< weighted, at `state`; negative: not computed
  int iterations = 0;
  bool converged = false;
  std::string message;
};

enum class TrustRegion {
  none,    ///< steps of Gauss-Newton: the reference, fast near the minimum
  damped,  ///< Levenberg-Marquardt: for starts from which Gauss-Newton diverges, singular matrices
};

/// The same least squares by Ceres: the reference, and what is left where our own steps fail.
/// @param weights one an edge of the SolverGraph, or empty
[[nodiscard]] CeresResult solve_with_ceres(const SolverGraph& graph, const PoseGraph& poses,
                                           const SlotPoses& start, std::span<const double> weights,
                                           TrustRegion trust_region, int max_iterations);

}  // namespace roomatlas
