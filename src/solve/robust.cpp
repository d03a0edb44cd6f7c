// SPDX-License-Identifier: GPL-3.0-or-later
#include "robust.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "grow_closures.hpp"

namespace roomatlas {

RobustSolution solve_robustly(const PoseGraph& graph, LeastSquares& squares) {
  ClosureGrowth growth(graph, squares);
  growth.run();
  RobustSolution result;
  result.weights = growth.weights();
  result.solved = growth.solved();
  result.issues = growth.issues();
  return result;
}

}  // namespace roomatlas
