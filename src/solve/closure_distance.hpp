// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "least_squares.hpp"

namespace roomatlas {

/// How a closure fits what the other accepted edges say.
struct ClosureTest {
  std::int32_t edge = 0;  ///< of the SolverGraph
  /// Squared Mahalanobis distance between the measurement and what all other accepted edges
  /// predict, with the uncertainty of both: chi-square distributed, 3 degrees of freedom.
  double distance = 0.0;
  /// Logarithm of the square root of the determinant of that uncertainty, m^2 rad: the larger, the
  /// easier a false closure passes by chance.
  double log_volume = 0.0;
};

/// Tests all loops at the minimum under these weights: 1 accepted, 0 not. Empty where the system
/// is singular. One factorisation and one selected inverse.
[[nodiscard]] std::vector<ClosureTest> test_closures(const PoseGraph& poses, LeastSquares& squares,
                                                     const SlotPoses& state,
                                                     std::span<const double> weights);

}  // namespace roomatlas
