// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace roomatlas::apps {

std::string duration_text(double duration_s) {
  constexpr long kMinute = 60;
  constexpr long kHour = 60 * kMinute;
  constexpr double kLongest_s = 1e9;
  const long seconds = std::lround(std::clamp(duration_s, 0.0, kLongest_s));
  if (seconds < kMinute) return fmt::format("{} s", seconds);
  if (seconds < kHour) return fmt::format("{} min {} s", seconds / kMinute, seconds % kMinute);
  return fmt::format("{} h {} min", seconds / kHour, seconds % kHour / kMinute);
}

std::string progress_text(const std::string& stage, double done, double elapsed_s) {
  constexpr double kSoonest_s = 1.0;
  constexpr double kLeastDone = 0.02;
  if (done < 0.0) {
    return elapsed_s < kSoonest_s ? stage : stage + " for " + duration_text(elapsed_s);
  }
  const double share = std::min(done, 1.0);
  const std::string text = fmt::format("{} {:.0f} %", stage, std::floor(100.0 * share));
  if (elapsed_s < kSoonest_s || share < kLeastDone) return text;
  return text + ", " + duration_text(elapsed_s * (1.0 - share) / share) + " left";
}

}  // namespace roomatlas::apps
