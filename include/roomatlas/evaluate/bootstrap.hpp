// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace roomatlas {

struct BootstrapOptions {
  int resamples = 1000;      ///< more steadies the ends of the interval; the time grows with it
  double confidence = 0.95;  ///< (0, 1)
  std::uint64_t seed = 1;    ///< decides every draw
};

/// A mean and the interval that holds the true one with the chosen confidence. NaN: nothing to
/// draw from.
struct ConfidenceInterval {
  double mean = std::numeric_limits<double>::quiet_NaN();
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

/// Length of the blocks that are drawn from a list of `count` errors: the root of the count,
/// rounded up.
[[nodiscard]] std::size_t block_length(std::size_t count);

/// Interval of the mean by the circular block bootstrap (Politis and Romano 1992): lists as long
/// as the errors are put together from blocks of neighbours that begin anywhere, going round at
/// the end, and the percentiles of their means are taken. Errors of neighbouring poses resemble
/// each other; drawing them one by one would make the interval too short. The same errors and
/// options give the same interval. What it cannot know: whether another drive would go as well.
[[nodiscard]] ConfidenceInterval bootstrap_mean(const std::vector<double>& errors,
                                                const BootstrapOptions& options);

}  // namespace roomatlas
