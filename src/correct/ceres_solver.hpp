// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "linearise.hpp"

namespace roomatlas {

struct CeresResult {
  State state;
  double chi_square = -1.0;
  int iterations = 0;
  bool converged = false;
  std::string message;
};

/// The same least squares by Ceres: the reference, and what is left where the block factorisation
/// fails, because its trust region stands a singular matrix.
/// @param weights one an edge of the SolverGraph, or empty
[[nodiscard]] CeresResult solve_with_ceres(const SolverGraph& graph, const PoseGraph& poses,
                                           const State& start, std::span<const double> weights,
                                           int max_iterations);

}  // namespace roomatlas
