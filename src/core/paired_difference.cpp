// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/paired_difference.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace roomatlas {

bool PairedDifference::is_within_chance() const {
  constexpr double kOneSided = 1.645;  // quantile 0.95 of the normal distribution
  return sum <= kOneSided * standard_error;
}

PairedDifference paired_difference(std::span<const double> first, std::span<const double> second) {
  if (first.size() != second.size()) {
    throw std::invalid_argument("paired_difference: the two are not equally many");
  }
  PairedDifference result;
  const auto count = static_cast<double>(first.size());
  for (std::size_t i = 0; i < first.size(); ++i) result.sum += first[i] - second[i];
  if (first.size() < 2) return result;
  double squares = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double off = first[i] - second[i] - result.sum / count;
    squares += off * off;
  }
  result.standard_error = std::sqrt(squares * count / (count - 1.0));
  return result;
}

}  // namespace roomatlas
