// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/sweep_path.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::io {
namespace {

// A robot that moves and turns less than this in a sweep is taken for standing: what the beams are
// off by is less than the error of their ranges, and odometry of so short a time, which often lags,
// is no better.
constexpr double kMovesM = 0.03;
constexpr double kMovedRad = radians(1.0);
// Of a sweep that began at another time than the reading this share of it: the time between is much
// the same in every reading, so that what is off adds up.
constexpr double kStillShare = 0.2;
constexpr int kKnots = 16;

}  // namespace

SweepPath::SweepPath(const RobotPoses& poses, std::int64_t reading_ns, std::int64_t begin_ns,
                     std::int64_t end_ns)
    : still_share_(begin_ns == reading_ns ? 1.0 : kStillShare) {
  if (end_ns == begin_ns && begin_ns == reading_ns) return;
  const auto from = poses.odom_from_base(reading_ns);
  if (!from) return;
  const Pose2 robot_from_odom = inverse(planar(from->transform));
  for (int knot = 0; knot <= kKnots; ++knot) {
    const double passed_ns = static_cast<double>(end_ns - begin_ns) * knot / kKnots;
    const auto pose = poses.odom_from_base(begin_ns + static_cast<std::int64_t>(passed_ns));
    knots_.push_back(robot_from_odom * planar(pose->transform));
  }
}

bool SweepPath::moves() const {
  return std::any_of(knots_.begin(), knots_.end(), [&](const Pose2& pose) {
    return pose.position().norm() > still_share_ * kMovesM ||
           std::abs(pose.theta_rad) > still_share_ * kMovedRad;
  });
}

Pose2 SweepPath::at(double share) const {
  if (knots_.empty()) return {};
  const double place = kKnots * std::clamp(share, 0.0, 1.0);
  const auto before = std::min(static_cast<std::size_t>(place), std::size_t{kKnots - 1});
  return interpolate(knots_[before], knots_[before + 1], place - static_cast<double>(before));
}

}  // namespace roomatlas::io
