// SPDX-License-Identifier: GPL-3.0-or-later
#include "odometry_track.hpp"

#include <cmath>

namespace roomatlas::io {
namespace {

/// The pose between two neighbours; nothing when they do not enclose the time.
std::optional<Pose2> between(const StampedPose& from, const StampedPose& to, double timestamp_s) {
  if (timestamp_s < from.timestamp_s || timestamp_s > to.timestamp_s) return std::nullopt;
  const double span_s = to.timestamp_s - from.timestamp_s;
  if (span_s <= 0.0) return from.pose;
  return interpolate(from.pose, to.pose, (timestamp_s - from.timestamp_s) / span_s);
}

}  // namespace

void OdometryTrack::add(const StampedPose& line) {
  if (!lines_.empty() && line.timestamp_s < lines_.back().timestamp_s) lines_.clear();
  if (lines_.size() >= kLookBack) lines_.pop_front();
  lines_.push_back(line);
}

std::optional<Pose2> OdometryTrack::at(double timestamp_s) const {
  if (lines_.empty()) return std::nullopt;
  if (timestamp_s == lines_.back().timestamp_s) return lines_.back().pose;
  for (std::size_t i = lines_.size() - 1; i > 0; --i) {
    if (auto pose = between(lines_[i - 1], lines_[i], timestamp_s)) return pose;
  }
  return std::nullopt;
}

std::optional<StampedPose> OdometryTrack::newest() const {
  if (lines_.empty()) return std::nullopt;
  return lines_.back();
}

std::optional<Pose2> AwaitedPose::see(const StampedPose& line) {
  if (!first_after_) first_after_ = line;
  ++seen_;
  if (previous_) {
    if (auto pose = between(*previous_, line, timestamp_s_)) return pose;
    const bool stepped_back = line.timestamp_s < previous_->timestamp_s;
    if (stepped_back && timestamp_s_ >= previous_->timestamp_s) return give_up();
  } else if (line.timestamp_s >= timestamp_s_) {
    return line.pose;
  }
  previous_ = line;
  if (seen_ >= kLookAhead) return give_up();
  return std::nullopt;
}

std::optional<Pose2> AwaitedPose::give_up() const {
  if (!before_ && !first_after_) return std::nullopt;
  if (!before_) return first_after_->pose;
  if (!first_after_) return before_->pose;
  const double to_before_s = std::abs(timestamp_s_ - before_->timestamp_s);
  const double to_after_s = std::abs(timestamp_s_ - first_after_->timestamp_s);
  return to_after_s < to_before_s ? first_after_->pose : before_->pose;
}

}  // namespace roomatlas::io
