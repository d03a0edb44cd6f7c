// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace roomatlas {

/// How much more speaks for one explanation of the same observations than for another, from what
/// each piece of evidence says of both.
struct PairedDifference {
  double sum = 0.0;             ///< of the first less the second
  double standard_error = 0.0;  ///< of that sum, as the pieces scatter

  /// Whether chance alone may have preferred the first: a test of two models that are not nested
  /// (Vuong 1989, "Likelihood ratio tests for model selection and non-nested hypotheses"),
  /// one-sided at 5 %. Of explanations that are equally good 5 % are not within it.
  [[nodiscard]] bool is_within_chance() const;
};

/// @param first,second what independent pieces of evidence say for each, in one order
/// @throws std::invalid_argument where they are not equally many
[[nodiscard]] PairedDifference paired_difference(std::span<const double> first,
                                                 std::span<const double> second);

}  // namespace roomatlas
