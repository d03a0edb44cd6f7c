// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdio>

#include "roomatlas/solve/optimize.hpp"

namespace roomatlas {

std::string words(const EdgeVerdict& verdict) {
  std::array<char, 32> figure{};
  std::snprintf(figure.data(), figure.size(), "%.3g", verdict.chi_square);
  const std::string chi_square = std::string("chi-square ") + figure.data();
  switch (verdict.reason) {
    case EdgeReason::not_decided:
      return "not decided";
    case EdgeReason::least_squares:
      return "all edges count: " + chi_square;
    case EdgeReason::reweighted:
      std::snprintf(figure.data(), figure.size(), "%.3g", verdict.weight);
      return std::string("counts with weight ") + figure.data() + ": " + chi_square;
    case EdgeReason::never_rejected:
      return "odometry or trusted, never rejected: " + chi_square;
    case EdgeReason::fits:
      return "agrees with odometry and the other closures: " + chi_square;
    case EdgeReason::contradicts:
      return "contradicts odometry and the accepted closures: " + chi_square;
  }
  return {};
}

}  // namespace roomatlas
