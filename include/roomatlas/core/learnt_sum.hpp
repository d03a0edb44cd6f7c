// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace roomatlas {

/// One figure that a judgement is made from.
struct JudgedFigure {
  std::string name;
  double value = 0.0;
};

/// A figure's part in a sum.
struct LearntTerm {
  const char* name;
  double mean;       ///< over what was learnt from
  double deviation;  ///< the same; at 3 of them figures are cut off
  double weight;     ///< of (figure - mean) / deviation
};

/// bias + the terms: log odds, or a logarithm.
struct LearntSum {
  double bias;
  std::span<const LearntTerm> terms;
};

/// A term's part for these figures.
/// @throws std::logic_error where they have none of its name
[[nodiscard]] double part_of(const LearntTerm& term, const std::vector<JudgedFigure>& figures);
[[nodiscard]] double sum_of(const LearntSum& sum, const std::vector<JudgedFigure>& figures);

}  // namespace roomatlas
