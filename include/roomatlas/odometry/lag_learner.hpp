// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <deque>

#include "roomatlas/core/packed.hpp"

namespace roomatlas {

/// Learns by how much odometry's poses are older than the ranges beside them, from turns: the shift
/// in time with which odometry's headings foretell matched ones best. Where the robot drives
/// straight nothing is learnt. Constant cost and memory.
class LagLearner {
 public:
  /// @param timestamp_s of the reading
  /// @param odometry_rad heading as reported beside it; wrapped or not
  /// @param matched_turn_rad since the reading before, as matched
  void add(double timestamp_s, double odometry_rad, double matched_turn_rad);
  /// The next reading could not be matched, or does not follow the last.
  void interrupt() { recent_.clear(); }

  /// In seconds, positive where odometry is late (`OdometryHabits::lag_s`), from -0.5 to 0.8; 0
  /// until another is clearly likelier, and where it is less than the time between two readings:
  /// between them odometry is guessed, which costs as much as so small a lag.
  [[nodiscard]] double lag_s() const;

 private:
  static constexpr int kShifts = 27;
  struct Sample {
    double timestamp_s = 0.0;
    double odometry_rad = 0.0;  ///< unwrapped
    double matched_rad = 0.0;   ///< sum of turns
  };
  /// Both ends interpolated between samples that are known to enclose them.
  [[nodiscard]] double turn_between(double Sample::*heading, double from_s, double to_s) const;
  void learn_at(double timestamp_s);

  template <MaybeConst<Sample> Value, typename Visit>
  friend void fields_of(Value& sample, Visit& visit) {
    visit(sample.timestamp_s, sample.odometry_rad, sample.matched_rad);
  }
  template <MaybeConst<LagLearner> Value, typename Visit>
  friend void fields_of(Value& learner, Visit& visit) {
    visit(learner.recent_, learner.learnt_to_s_, learner.gaps_s_, learner.gaps_);
    for (auto& loss : learner.loss_) visit(loss);
  }

  std::deque<Sample> recent_;
  double learnt_to_s_ = 0.0;
  double gaps_s_ = 0.0;                 ///< sum of the times between readings, of ...
  int gaps_ = 0;                        ///< ... so many
  std::array<double, kShifts> loss_{};  ///< of what each shift foretold
};

}  // namespace roomatlas
