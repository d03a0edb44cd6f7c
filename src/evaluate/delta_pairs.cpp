// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/issue.hpp"
#include "roomatlas/evaluate/ape_rpe.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

Pairs by_frames(std::size_t poses, const RpeOptions& options) {
  if (options.delta != std::floor(options.delta) || options.delta < 1.0) {
    throw UsageError("--delta: expected a whole number of frames from 1, or --delta-unit m or d");
  }
  Pairs pairs;
  if (options.delta >= static_cast<double>(poses)) return pairs;
  const auto delta = static_cast<std::size_t>(options.delta);
  const std::size_t step = options.all_pairs ? 1 : delta;
  for (std::size_t i = 0; i + delta < poses; i += step) pairs.emplace_back(i, i + delta);
  return pairs;
}

/// Distance along the path from the first pose to each.
std::vector<double> path_to(const std::vector<Pose2>& poses) {
  std::vector<double> path_m(poses.size(), 0.0);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    path_m[i] = path_m[i - 1] + (poses[i].position() - poses[i - 1].position()).norm();
  }
  return path_m;
}

Pairs by_path_end_to_end(const std::vector<Pose2>& poses, double delta_m) {
  Pairs pairs;
  std::optional<std::size_t> former;
  double driven_m = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i > 0) driven_m += (poses[i].position() - poses[i - 1].position()).norm();
    if (driven_m < delta_m) continue;
    if (former) pairs.emplace_back(*former, i);
    former = i;
    driven_m = 0.0;
  }
  return pairs;
}

Pairs by_path_all(const std::vector<Pose2>& poses, double delta_m, double tolerance_m) {
  const std::vector<double> path_m = path_to(poses);
  Pairs pairs;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const auto away_m = [&](std::size_t j) { return std::abs(path_m[j] - path_m[i] - delta_m); };
    // Path lengths never shrink, so the nearest is at the first place beyond delta, or before it.
    const auto beyond = std::lower_bound(path_m.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                         path_m.end(), path_m[i] + delta_m);
    auto place = static_cast<std::size_t>(beyond - path_m.begin());
    if (place == poses.size() || (place > i + 1 && away_m(place - 1) <= away_m(place))) --place;
    while (place > i + 1 && path_m[place - 1] == path_m[place]) --place;  // the first of equals
    if (away_m(place) <= tolerance_m) pairs.emplace_back(i, place);
  }
  return pairs;
}

Pairs by_turn_end_to_end(const std::vector<Pose2>& poses, double delta_rad) {
  Pairs pairs;
  std::size_t start = 0;
  double turned_rad = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    turned_rad += std::abs(wrap_angle(poses[i].theta_rad - poses[i - 1].theta_rad));
    if (turned_rad < delta_rad) continue;
    pairs.emplace_back(start, i);
    start = i;
    turned_rad = 0.0;
  }
  return pairs;
}

Pairs by_turn_all(const std::vector<Pose2>& poses, double delta_rad, double tolerance_rad) {
  Pairs pairs;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t j = i + 1; j < poses.size(); ++j) {
      const double turn_rad = std::abs(wrap_angle(poses[j].theta_rad - poses[i].theta_rad));
      if (std::abs(turn_rad - delta_rad) <= tolerance_rad) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> delta_pairs(const std::vector<Pose2>& poses,
                                                             const RpeOptions& options) {
  if (!(options.delta >= 0.0)) throw UsageError("--delta: expected a number from 0");
  const double tolerance = options.delta * options.relative_tolerance;
  switch (options.unit) {
    case DeltaUnit::frames:
      return by_frames(poses.size(), options);
    case DeltaUnit::metres:
      return options.all_pairs ? by_path_all(poses, options.delta, tolerance)
                               : by_path_end_to_end(poses, options.delta);
    case DeltaUnit::degrees:
    case DeltaUnit::radians:
      break;
  }
  const double to_rad = options.unit == DeltaUnit::degrees ? kPi / 180.0 : 1.0;
  const double delta_rad = options.delta * to_rad;
  if (delta_rad > kPi) throw UsageError("--delta: an angle is at most 180 degrees");
  return options.all_pairs ? by_turn_all(poses, delta_rad, tolerance * to_rad)
                           : by_turn_end_to_end(poses, delta_rad);
}

}  // namespace roomatlas
