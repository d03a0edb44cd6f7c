// SPDX-License-Identifier: GPL-3.0-or-later
#include "wider_matches.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace roomatlas {
namespace {

constexpr double kAlikeM = 0.6;             // moves that end this near to each other are one ...
constexpr double kAlikeRad = radians(3.0);  // ... and turn alike. Larger believes two errors as one

Pose2 motion_of(const WiderMatch& wider) {
  return wider.building_from_is * inverse(wider.building_from_was);
}

/// Whether the second would move the first's room to where the first moves it.
bool are_alike(const WiderMatch& first, const WiderMatch& second) {
  const Pose2 apart =
      inverse(first.building_from_is) * (motion_of(second) * first.building_from_was);
  return apart.position().norm() < kAlikeM && std::abs(wrap_angle(apart.theta_rad)) < kAlikeRad;
}

}  // namespace

std::vector<WiderMatch> take_most_alike(std::vector<WiderMatch>& found) {
  const auto gain_like = [&](const WiderMatch& one) {
    int gain = 0;
    for (const WiderMatch& other : found) gain += are_alike(one, other) ? other.gain : 0;
    return gain;
  };
  const WiderMatch best =
      *std::max_element(found.begin(), found.end(),
                        [&](const auto& a, const auto& b) { return gain_like(a) < gain_like(b); });
  const auto alike = std::stable_partition(
      found.begin(), found.end(), [&](const auto& other) { return !are_alike(best, other); });
  const std::vector<WiderMatch> taken(alike, found.end());
  found.erase(alike, found.end());
  return taken;
}

int gain_of(const std::vector<WiderMatch>& matches) {
  return std::accumulate(matches.begin(), matches.end(), 0,
                         [](int sum, const WiderMatch& wider) { return sum + wider.gain; });
}

}  // namespace roomatlas
