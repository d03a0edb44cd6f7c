// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/sweep.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::io {
namespace {

// Drivers report their maximum for nothing: so near to it, by a float's rounding below and by their
// own above, it is meant.
constexpr double kRoundingShare = 1.2e-7;
constexpr double kAboveShare = 1e-3;

bool is_invalid(float range_m) { return std::isnan(range_m) || range_m <= 0.0F; }

bool is_beyond(float range_m, const RangeLimits& limits) {
  return std::isfinite(range_m) && range_m > limits.max_m * (1.0 + kAboveShare);
}

}  // namespace

Echo echo_of(float range_m, const RangeLimits& limits) {
  if (is_invalid(range_m) || is_beyond(range_m, limits)) return Echo::unknown;
  if (range_m < limits.min_m) return Echo::unknown;
  const double most_m = std::min(limits.max_m * (1.0 - kRoundingShare), limits.trusted_m);
  return range_m >= most_m ? Echo::nothing : Echo::surface;  // +Inf as well
}

void EchoCounts::add(float range_m, const RangeLimits& limits) {
  ++beams;
  if (is_invalid(range_m)) {
    ++invalid;
  } else if (is_beyond(range_m, limits)) {
    ++too_far;
  } else if (range_m < limits.min_m) {
    ++too_near;
  } else if (echo_of(range_m, limits) == Echo::nothing) {
    ++nothing;
  }
}

}  // namespace roomatlas::io
