// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "roomatlas/evaluate/plan_errors.hpp"

namespace roomatlas {

/// Part over whole; 0 where there is no whole.
[[nodiscard]] inline double ratio(double part, double whole) {
  return whole > 0.0 ? part / whole : 0.0;
}

/// @param found, wanted how many there are on either side, of which `matched` belong together
[[nodiscard]] inline DetectionScore detection_score(std::int64_t matched, std::int64_t found,
                                                    std::int64_t wanted) {
  const auto m = static_cast<double>(matched);
  const auto f = static_cast<double>(found);
  const auto w = static_cast<double>(wanted);
  return {matched, ratio(m, f), ratio(m, w), ratio(2.0 * m, f + w)};
}

}  // namespace roomatlas
