// SPDX-License-Identifier: GPL-3.0-or-later
#include "rehearsal.hpp"

#include <cmath>

namespace roomatlas {
namespace {

constexpr double kEnoughM = 20.0;           // of path: habits have settled, drift is small
constexpr double kMuchBias = radians(3.0);  // rad a metre: less the sweeps take out from the first
                                            // metre on, and the first room is none the better
constexpr std::int64_t kMostReadings = 4000;  // all of them are kept until then

bool is_much(const OdometryHabits& habits) {
  return habits.lag_s != 0.0 || std::abs(habits.bias_rad_per_m) > kMuchBias;
}

}  // namespace

void Rehearsal::add(const DeadReckoned& reading) {
  if (is_over()) return;
  has_laser_ = can_be_matched(reading.reading);
  ++readings_;
  waiting_.add(reading);
  const auto lag_s = [&] {
    const auto habits = localizer_.habits();
    return habits ? habits->lag_s : 0.0;
  };
  while (const auto next = waiting_.next(lag_s())) follow(*next);
}

void Rehearsal::follow(const DeadReckoned& next) {
  const Pose2& reckoned = next.reckoned_from_robot;
  const Pose2 step =
      last_reckoned_from_robot_ ? inverse(*last_reckoned_from_robot_) * reckoned : Pose2{};
  room_from_robot_ = localizer_.locate(next.reading, room_from_robot_ * step, step);
  driven_m_ += step.position().norm();
  last_reckoned_from_robot_ = reckoned;
}

bool Rehearsal::is_over() const {
  return !has_laser_ || driven_m_ > kEnoughM || readings_ >= kMostReadings;
}

LearntOdometry Rehearsal::learnt() const {
  const auto habits = localizer_.habits();
  if (!habits || !is_much(*habits)) return {};
  LearntOdometry learnt = localizer_.learnt();
  learnt.habits.interrupt();
  learnt.lag.interrupt();
  return learnt;
}

}  // namespace roomatlas
