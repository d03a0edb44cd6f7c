// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/steered_odometry.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace roomatlas::io {
namespace {

// Odometry that reports less than this between two poses stands.
constexpr double kStandsM = 5e-4;
constexpr double kStandsRad = radians(0.05);
constexpr std::int64_t kStill_ns = 1'000'000'000;  // so long at a time drift is learnt from
constexpr double kDriftPerStill = 0.1;             // of what one such time says is believed
constexpr double kMostDrift = radians(1.0);  // a second; more is a robot that is turned by hand

/// A step with another turn: an arc's chord points halfway between its two headings.
Pose2 turned_by(const Pose2& step, double turn_rad) {
  const Point2 chord =
      Pose2{0.0, 0.0, (turn_rad - step.theta_rad) / 2.0} * Point2(step.x_m, step.y_m);
  return {chord.x(), chord.y(), wrap_angle(turn_rad)};
}

}  // namespace

void SteeredOdometry::add_turn(std::int64_t stamp_ns, const Eigen::Vector3d& turn_rad_per_s) {
  turns_.add(stamp_ns, turn_rad_per_s);
  if (has_odometry_) {
    settle();
  } else {
    add_odometry(stamp_ns, {});
  }
}

void SteeredOdometry::add_odometry(std::int64_t stamp_ns, const Pose2& odom_from_robot) {
  const bool is_set_back =
      !settled_.empty() && stamp_ns < settled_.back().stamp_ns - TransformTrack::kKept_ns;
  if (is_set_back) {  // what waits is of the time before
    while (!waiting_.empty()) {
      settle(waiting_.front());
      waiting_.pop_front();
    }
    Sample last = settled_.back();
    last.stamp_ns = stamp_ns - 1;
    settled_.assign(1, last);
    turns_ = {};
  }
  const auto place = std::lower_bound(
      waiting_.begin(), waiting_.end(), stamp_ns,
      [](const Sample& kept, std::int64_t stamp) { return kept.stamp_ns < stamp; });
  const bool is_there = place != waiting_.end() && place->stamp_ns == stamp_ns;
  const bool is_late = !settled_.empty() && stamp_ns <= settled_.back().stamp_ns;
  if (is_there || is_late) return;
  waiting_.insert(place, {stamp_ns, odom_from_robot, {}});
  settle();
}

/// Takes the poses whose turn is known by now, or was waited for in vain.
void SteeredOdometry::settle() {
  while (!waiting_.empty()) {
    const std::int64_t stamp_ns = waiting_.front().stamp_ns;
    const bool is_known = turns_.newest_ns() && *turns_.newest_ns() >= stamp_ns;
    const bool is_given_up = waiting_.back().stamp_ns - stamp_ns > kWaits_ns;
    if (!is_known && !is_given_up) return;
    settle(waiting_.front());
    waiting_.pop_front();
  }
}

void SteeredOdometry::settle(const Sample& next) {
  Sample settled = next;
  settled.steered = next.reported;
  if (!settled_.empty()) {
    const Sample& last = settled_.back();
    const Pose2 step = inverse(last.reported) * next.reported;
    const auto by_gyro = turn(last.stamp_ns, next.stamp_ns);
    if (!by_gyro) ++without_gyro_;
    settled.steered = last.steered * (by_gyro ? turned_by(step, *by_gyro) : step);
    if (has_odometry_) learn_drift(next);
  } else {
    still_since_ns_ = next.stamp_ns;
  }
  settled_.push_back(settled);
  while (settled_.size() > 2 && (settled_.size() > TransformTrack::kMost ||
                                 next.stamp_ns - settled_[1].stamp_ns > TransformTrack::kKept_ns)) {
    settled_.pop_front();
  }
}

void SteeredOdometry::learn_drift(const Sample& next) {
  const Pose2 step = inverse(settled_.back().reported) * next.reported;
  if (step.position().norm() > kStandsM || std::abs(step.theta_rad) > kStandsRad) {
    still_since_ns_ = next.stamp_ns;
    return;
  }
  if (next.stamp_ns - still_since_ns_ < kStill_ns) return;
  const auto turned = turn(still_since_ns_, next.stamp_ns);
  const double off = turned ? *turned / seconds(next.stamp_ns - still_since_ns_) : 0.0;
  if (std::abs(off) < kMostDrift) drift_ += kDriftPerStill * off;
  still_since_ns_ = next.stamp_ns;
}

/// Without the drift.
std::optional<double> SteeredOdometry::turn(std::int64_t from_ns, std::int64_t to_ns) const {
  const auto about_axes = turns_.turn(from_ns, to_ns);
  if (!about_axes) return std::nullopt;
  return gyro_.up.dot(*about_axes) - drift_ * seconds(to_ns - from_ns);
}

std::optional<TransformAt> SteeredOdometry::at(std::int64_t stamp_ns) const {
  if (settled_.empty()) return std::nullopt;
  const Sample& first = settled_.front();
  const Sample& last = settled_.back();
  if (stamp_ns <= first.stamp_ns) {
    return TransformAt{upright(first.steered), first.stamp_ns - stamp_ns};
  }
  if (stamp_ns >= last.stamp_ns)
    return TransformAt{upright(last.steered), stamp_ns - last.stamp_ns};
  const auto after = std::lower_bound(
      settled_.begin(), settled_.end(), stamp_ns,
      [](const Sample& kept, std::int64_t stamp) { return kept.stamp_ns < stamp; });
  const Sample& before = *std::prev(after);
  const double share = static_cast<double>(stamp_ns - before.stamp_ns) /
                       static_cast<double>(after->stamp_ns - before.stamp_ns);
  Pose2 pose = interpolate(before.steered, after->steered, share);
  if (const auto turned = turn(before.stamp_ns, stamp_ns)) {
    pose.theta_rad = wrap_angle(before.steered.theta_rad + *turned);
  }
  return TransformAt{upright(pose), 0};
}

}  // namespace roomatlas::io
