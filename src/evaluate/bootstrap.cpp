// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace roomatlas {
namespace {

/// A whole number in [0, count), the same with every standard library.
std::size_t draw(std::mt19937_64& random, std::size_t count) {
  const double unit = static_cast<double>(random() >> 11U) * 0x1.0p-53;  // [0, 1)
  return std::min(count - 1, static_cast<std::size_t>(unit * static_cast<double>(count)));
}

/// Between the two values of a sorted list that enclose the share, as numpy does by default.
double percentile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

}  // namespace

std::size_t block_length(std::size_t count) {
  auto length = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  return std::max<std::size_t>(length, 1);
}

ConfidenceInterval bootstrap_mean(const std::vector<double>& errors,
                                  const BootstrapOptions& options) {
  ConfidenceInterval interval;
  const std::size_t count = errors.size();
  if (count == 0 || options.resamples < 1) return interval;
  // Sums up to each place, going round once: the sum of any block is one difference.
  std::vector<double> sums(2 * count + 1, 0.0);
  for (std::size_t i = 0; i < 2 * count; ++i) sums[i + 1] = sums[i] + errors[i % count];
  interval.mean = sums[count] / static_cast<double>(count);
  if (!std::isfinite(interval.mean)) return interval;

  const std::size_t length = block_length(count);
  std::mt19937_64 random(options.seed);
  std::vector<double> means;
  for (int resample = 0; resample < options.resamples; ++resample) {
    double sum = 0.0;
    for (std::size_t drawn = 0; drawn < count; drawn += length) {
      const std::size_t begin = draw(random, count);
      sum += sums[begin + std::min(length, count - drawn)] - sums[begin];
    }
    means.push_back(sum / static_cast<double>(count));
  }
  std::sort(means.begin(), means.end());
  interval.low = percentile(means, (1.0 - options.confidence) / 2.0);
  interval.high = percentile(means, (1.0 + options.confidence) / 2.0);
  return interval;
}

}  // namespace roomatlas
