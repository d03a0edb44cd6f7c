// SPDX-License-Identifier: GPL-3.0-or-later
#include "robust.hpp"

namespace roomatlas {
RobustSolution solve_robustly(const PoseGraph&, LeastSquares& squares) {
  RobustSolution s;
  s.solved = squares.solve({});
  return s;
}
}  // namespace roomatlas
