// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/alignment.hpp"

#include "roomatlas/core/geometry.hpp"

#include <algorithm>
#include <cmath>

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
  const double count = static_cast<double>(used);
  Point2 mean_estimate = Point2::Zero();
  Point2 mean_truth = Point2::Zero();
  for (std::size_t i = 0; i < used; ++i) {
    mean_estimate += matched.estimate_from_robot[i].position() / count;
    mean_truth += matched.truth_from_robot[i].position() / count;
  }
  double sine = 0.0;
  double cosine = 0.0;
  for (std::size_t i = 0; i < used; ++i) {
    const Point2 from = matched.estimate_from_robot[i].position() - mean_estimate;
    const Point2 to = matched.truth_from_robot[i].position() - mean_truth;
    sine += cross(from, to);
    cosine += from.dot(to);
  }
  const Pose2 turn{0.0, 0.0, wrap_angle(std::atan2(sine, cosine))};
  const Point2 shift = mean_truth - turn * mean_estimate;
  return {shift.x(), shift.y(), turn.theta_rad};
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
