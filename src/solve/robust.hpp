// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "least_squares.hpp"

namespace roomatlas {

struct RobustSolution {
  Solved solved;
  std::vector<double> weights;  ///< one an edge of the SolverGraph: 1 accepted, 0 rejected
  Issues issues;                ///< what makes the choice doubtful
};

/// Chooses the closures that odometry and the other closures bear out, and solves with them.
[[nodiscard]] RobustSolution solve_robustly(const PoseGraph& graph, LeastSquares& squares);

}  // namespace roomatlas
