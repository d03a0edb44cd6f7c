// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "least_squares.hpp"

namespace roomatlas {

/// Quantile of the chi-square distribution, by the cube root of Wilson and Hilferty (1931): good to
/// a few per mille from three degrees of freedom on. 0 for none.
/// @param normal_quantile of the wanted probability, such as 3.29 for 0.9995
[[nodiscard]] double chi_square_quantile(std::int64_t degrees_of_freedom, double normal_quantile);

/// Degrees of freedom and range for the edges with weight.
[[nodiscard]] ChiSquareRange expected_chi_square(const SolverGraph& graph,
                                                 std::span<const double> weights);

/// Says what speaks against a plain least squares result.
void judge(const PoseGraph& graph, const Solved& solved, OptimizeResult& result);

}  // namespace roomatlas
