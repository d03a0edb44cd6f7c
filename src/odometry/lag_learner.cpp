// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/lag_learner.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/core/pose2.hpp"

namespace roomatlas {
namespace {

constexpr double kStepS = 0.05;     // between shifts
constexpr int kNoShift = 10;        // its index: the first is half a second early
constexpr double kLeastS = -0.5;    // of the shifts, and ...
constexpr double kMostS = 0.8;      // ... the last
constexpr double kSpanS = 0.4;      // turns are compared over this time: shorter, the match's noise
                                    // counts; longer, a turn's begin and its end cancel out
constexpr double kEveryS = 0.2;     // spans overlap by half
constexpr double kMaxGapS = 0.35;   // between readings; farther apart, headings between are guessed
constexpr double kLeastRad = 0.05;  // a robot that turns less over all shifts tells no time
constexpr double kSigmaRad = 0.02;  // of a turn as matched, and ...
constexpr double kSigmaShare = 0.1;  // ... as reported, of the turn
constexpr double kLetsGo = 4.0;      // squared sigmas from which on Cauchy's loss lets go
constexpr double kClearly = 10.0;    // of log evidence, that a lag must bring

}  // namespace

double LagLearner::turn_between(double Sample::*heading, double from_s, double to_s) const {
  const auto at = [&](double time_s) {
    const auto after = std::lower_bound(
        recent_.begin() + 1, recent_.end() - 1, time_s,
        [](const Sample& sample, double time) { return sample.timestamp_s < time; });
    const auto before = after - 1;
    const double span_s = after->timestamp_s - before->timestamp_s;
    const double share = span_s > 0.0 ? (time_s - before->timestamp_s) / span_s : 0.0;
    return *before.*heading + share * (*after.*heading - *before.*heading);
  };
  return at(to_s) - at(from_s);
}

void LagLearner::learn_at(double timestamp_s) {
  const double from_s = timestamp_s - kSpanS;
  const double matched_rad = turn_between(&Sample::matched_rad, from_s, timestamp_s);
  std::array<double, kShifts> reported_rad{};
  for (int i = 0; i < kShifts; ++i) {
    const double shift_s = (i - kNoShift) * kStepS;
    reported_rad[static_cast<std::size_t>(i)] =
        turn_between(&Sample::odometry_rad, from_s + shift_s, timestamp_s + shift_s);
  }
  const auto [least, most] = std::minmax_element(reported_rad.begin(), reported_rad.end());
  if (*most - *least < kLeastRad) return;
  const double sigma_rad =
      std::hypot(kSigmaRad, kSigmaShare * std::max(std::abs(*least), std::abs(*most)));
  for (std::size_t i = 0; i < loss_.size(); ++i) {
    const double sigmas = (reported_rad[i] - matched_rad) / sigma_rad;
    loss_[i] += kLetsGo / 2.0 * std::log1p(sigmas * sigmas / kLetsGo);
  }
}

void LagLearner::add(double timestamp_s, double odometry_rad, double matched_turn_rad) {
  if (!recent_.empty()) {
    const double gap_s = timestamp_s - recent_.back().timestamp_s;
    if (!(gap_s >= 0.0) || gap_s > kMaxGapS) interrupt();
  }
  if (recent_.empty()) {
    recent_.push_back({timestamp_s, odometry_rad, 0.0});
    learnt_to_s_ = timestamp_s;
    return;
  }
  const Sample& last = recent_.back();
  gaps_s_ += timestamp_s - last.timestamp_s;
  ++gaps_;
  recent_.push_back({timestamp_s, last.odometry_rad + wrap_angle(odometry_rad - last.odometry_rad),
                     last.matched_rad + matched_turn_rad});
  const double at_s = timestamp_s - kMostS;
  const double first_s = at_s - kSpanS + kLeastS;
  if (first_s < recent_.front().timestamp_s) return;
  while (recent_.size() > 2 && recent_[1].timestamp_s <= first_s) recent_.pop_front();
  if (at_s < learnt_to_s_ + kEveryS) return;
  learnt_to_s_ = at_s;
  learn_at(at_s);
}

double LagLearner::lag_s() const {
  const auto best = std::min_element(loss_.begin(), loss_.end());
  if (loss_[kNoShift] - *best < kClearly) return 0.0;
  double lag_s = static_cast<double>(best - loss_.begin() - kNoShift) * kStepS;
  if (best != loss_.begin() && best + 1 != loss_.end()) {
    const double bend = *(best - 1) - 2.0 * *best + *(best + 1);
    if (bend > 0.0) lag_s += kStepS * (*(best - 1) - *(best + 1)) / (2.0 * bend);
  }
  return std::abs(lag_s) * gaps_ < gaps_s_ ? 0.0 : lag_s;
}

}  // namespace roomatlas
