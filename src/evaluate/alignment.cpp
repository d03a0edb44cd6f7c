// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/alignment.hpp"

#include "roomatlas/core/rigid_fit.hpp"

#include <algorithm>

namespace roomatlas {
namespace {

/// Looks one trajectory's times up in the other.
void look_up(const Trajectory& asking, PoseLookup answering, bool estimate_asks,
             MatchedPoses& matched) {
  for (const auto& [timestamp_s, asked] : asking) {
    const auto found = answering.next(timestamp_s);
    if (!found) continue;
    count(matched.use, *found);
    matched.timestamps_s.push_back(timestamp_s);
    matched.estimate_from_robot.push_back(estimate_asks ? asked : found->pose);
    matched.truth_from_robot.push_back(estimate_asks ? found->pose : asked);
  }
}

Pose2 least_squares(const MatchedPoses& matched, std::size_t used) {
  std::vector<PointPair> points;
  for (std::size_t i = 0; i < used; ++i) {
    points.push_back(
        {matched.estimate_from_robot[i].position(), matched.truth_from_robot[i].position()});
  }
  return rigid_fit(points);
}

}  // namespace

const char* to_string(Alignment alignment) {
  switch (alignment) {
    case Alignment::origin:
      return "origin";
    case Alignment::umeyama:
      return "umeyama";
    case Alignment::none:
      break;
  }
  return "none";
}

MatchedPoses match_poses(const Trajectory& estimate, const Trajectory& truth,
                         const MatchOptions& options, const Trajectory* carry) {
  MatchedPoses matched;
  const bool estimate_asks = carry == nullptr && estimate.size() <= truth.size();
  if (estimate_asks) {
    look_up(estimate, PoseLookup(truth, options), true, matched);
  } else {
    look_up(truth, PoseLookup(estimate, options, carry), false, matched);
  }
  return matched;
}

Pose2 truth_from_estimate(const MatchedPoses& matched, Alignment alignment, int poses_used) {
  if (matched.size() == 0 || alignment == Alignment::none) return {};
  if (alignment == Alignment::origin) {
    return matched.truth_from_robot.front() * inverse(matched.estimate_from_robot.front());
  }
  const std::size_t used =
      poses_used < 0
          ? matched.size()
          : std::clamp<std::size_t>(static_cast<std::size_t>(poses_used), 1, matched.size());
  return least_squares(matched, used);
}

}  // namespace roomatlas
