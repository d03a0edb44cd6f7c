// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/late_odometry.hpp"

#include <algorithm>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {
namespace {

constexpr double kKeptS = 1.5;  // of readings that were given: an odometry that is early needs them

}  // namespace

Pose2 LateOdometry::reckoned_at(double timestamp_s) const {
  const auto after = std::find_if(readings_.begin(), readings_.end(), [&](const DeadReckoned& one) {
    return one.reading.timestamp_s >= timestamp_s;
  });
  if (after == readings_.begin()) return after->reckoned_from_robot;
  const auto before = after - 1;
  if (after == readings_.end()) return before->reckoned_from_robot;
  const double span_s = after->reading.timestamp_s - before->reading.timestamp_s;
  const double share = (timestamp_s - before->reading.timestamp_s) / span_s;
  const Pose2 step = inverse(before->reckoned_from_robot) * after->reckoned_from_robot;
  return before->reckoned_from_robot *
         Pose2{share * step.x_m, share * step.y_m, share * step.theta_rad};
}

void LateOdometry::forget() {
  const double now_s = last_->reading.timestamp_s;
  while (given_ > 1 && readings_.front().reading.timestamp_s < now_s - kKeptS) {
    readings_.pop_front();
    --given_;
  }
}

std::optional<DeadReckoned> LateOdometry::next(double lag_s) {
  if (given_ == readings_.size()) return std::nullopt;
  const double at_s = readings_[given_].reading.timestamp_s;
  if (!has_ended_ && readings_.back().reading.timestamp_s < at_s + lag_s) return std::nullopt;
  DeadReckoned next = readings_[given_];
  is_shifted_ = is_shifted_ || lag_s != 0.0;
  if (is_shifted_ && last_) {
    const bool is_late = lag_s != 0.0;
    const Pose2 from = is_late ? reckoned_at(last_->reading.timestamp_s + lag_s)
                               : readings_[given_ - 1].reckoned_from_robot;
    const Pose2 to = is_late ? reckoned_at(at_s + lag_s) : next.reckoned_from_robot;
    next.reckoned_from_robot = last_->reckoned_from_robot * (inverse(from) * to);
  }
  ++given_;
  last_ = next;
  forget();
  return next;
}

std::optional<RangeReading> LateOdometry::skip() {
  if (given_ == readings_.size()) return std::nullopt;
  last_ = readings_[given_++];
  forget();
  return last_->reading;
}

void LateOdometry::resume(const State& state) {
  last_.value().reckoned_from_robot = state.last_reckoned_from_robot;
  is_shifted_ = state.is_shifted;
}

}  // namespace roomatlas
