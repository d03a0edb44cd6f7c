// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/time_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace roomatlas {
namespace {

constexpr double kAgree_s = 0.04;        // loggers are late by as much, and scans are farther apart
constexpr double kLeastShare = 0.5;      // of the truth's times: an offset that fits fewer is none
constexpr std::size_t kMostAsked = 200;  // times of the truth, each against all of the trajectory's

/// At most `kMostAsked` of the times, evenly spread, without those that are not finite.
std::vector<double> some_of(const std::vector<double>& times_s) {
  const std::size_t step = std::max<std::size_t>(1, times_s.size() / kMostAsked);
  std::vector<double> some;
  for (std::size_t i = 0; i < times_s.size(); i += step) {
    if (std::isfinite(times_s[i])) some.push_back(times_s[i]);
  }
  return some;
}

}  // namespace

std::optional<TimeOffset> fitting_offset(const std::vector<double>& trajectory_s,
                                         const std::vector<double>& truth_s) {
  const std::vector<double> asked_s = some_of(truth_s);
  std::vector<double> offsets_s;
  offsets_s.reserve(asked_s.size() * trajectory_s.size());
  for (const double asked : asked_s) {
    for (const double time_s : trajectory_s) {
      if (std::isfinite(time_s)) offsets_s.push_back(asked - time_s);
    }
  }
  std::sort(offsets_s.begin(), offsets_s.end());
  // Evenly stamped recordings fit at many offsets alike: then the beginnings decide.
  const double beginnings_s = time_range(truth_s).first_s - time_range(trajectory_s).first_s;
  double best_s = 0.0;
  std::size_t most = 0;
  for (std::size_t begin = 0, end = 0; begin < offsets_s.size(); ++begin) {
    while (end < offsets_s.size() && offsets_s[end] - offsets_s[begin] <= kAgree_s) ++end;
    const std::size_t votes = end - begin;
    const double middle_s = offsets_s[begin + votes / 2];
    const bool is_nearer = std::abs(middle_s - beginnings_s) < std::abs(best_s - beginnings_s);
    if (votes < most || (votes == most && !is_nearer)) continue;
    most = votes;
    best_s = middle_s;
  }
  if (most == 0) return std::nullopt;
  const double share =
      std::min(1.0, static_cast<double>(most) / static_cast<double>(asked_s.size()));
  if (share < kLeastShare || most < 2) return std::nullopt;
  return TimeOffset{best_s, share};
}

}  // namespace roomatlas
