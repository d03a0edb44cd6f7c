// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "roomatlas/core/packed.hpp"
#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

/// What has to be done about each step of odometry: what it does wrong, with the sign turned round.
/// Odometry that drifts left by 1 degree a metre has a bias of -1 degree a metre; one that reports
/// turns 4 % too large has a gain of 0.96.
///
/// Three learn them, each from what its mission has: `HabitLearner` from matched sweeps, `correct`
/// from the walls of rooms where nothing was matched (bias and gain), and
/// `correct_sonar_trajectory` from walls that sonars heard.
struct OdometryHabits {
  double lag_s = 0.0;           ///< odometry's poses hold for ranges that are this much older
  double bias_rad_per_m = 0.0;  ///< added to the heading for each metre driven forwards; positive
                                ///< turns left
  double turn_gain = 1.0;       ///< times each turn
  double length_scale = 1.0;    ///< times each length

  [[nodiscard]] bool operator==(const OdometryHabits&) const = default;
};

/// An odometry step, in the robot's frame before it, with bias, gain and scale put right. The lag
/// needs more than one step.
[[nodiscard]] Pose2 without_habits(const Pose2& step, const OdometryHabits& habits);

/// Learns bias, gain and scale while the robot drives, from how far matched motion differs from
/// odometry's over stretches of about a metre: two robust linear regressions with a prior at no
/// habits. Constant cost and memory.
class HabitLearner {
 public:
  /// @param odometry,matched the same motion, in the robot's frame before it
  /// @param is_length_seen whether walls fixed the length; in a bare corridor the match has
  ///   odometry's own
  void add(const Pose2& odometry, const Pose2& matched, bool is_length_seen);
  /// The next motion does not follow the last, or could not be matched.
  void interrupt() { stretch_ = {}; }

  /// Bias and gain once they have foretold headings better than odometry alone did, and the scale
  /// once it has so foretold lengths; until then none of them.
  [[nodiscard]] OdometryHabits habits() const;
  [[nodiscard]] int stretches() const { return stretches_; }

 private:
  struct Stretch {
    Pose2 odometry;
    Pose2 matched;
    double forwards_m = 0.0;
    double turned_rad = 0.0;  ///< left and right add up
    bool is_length_seen = true;
  };
  /// Loss of what was foretold of each stretch before it was learnt from.
  struct Foretold {
    double without = 0.0;
    double with = 0.0;
    [[nodiscard]] bool is_better() const { return with < without; }
  };
  void learn_heading();
  void learn_length();

  template <MaybeConst<Stretch> Value, typename Visit>
  friend void fields_of(Value& stretch, Visit& visit) {
    visit(stretch.odometry, stretch.matched, stretch.forwards_m, stretch.turned_rad,
          stretch.is_length_seen);
  }
  template <MaybeConst<Foretold> Value, typename Visit>
  friend void fields_of(Value& foretold, Visit& visit) {
    visit(foretold.without, foretold.with);
  }
  template <MaybeConst<HabitLearner> Value, typename Visit>
  friend void fields_of(Value& learner, Visit& visit) {
    visit(learner.stretch_, learner.stretches_, learner.heading_information_, learner.heading_sum_,
          learner.bias_and_gain_, learner.length_information_, learner.length_sum_,
          learner.more_length_, learner.headings_, learner.lengths_);
  }

  Stretch stretch_;
  int stretches_ = 0;
  Eigen::Matrix2d heading_information_ = Eigen::Matrix2d::Zero();  ///< of bias and gain - 1
  Eigen::Vector2d heading_sum_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d bias_and_gain_ = Eigen::Vector2d::Zero();
  double length_information_ = 0.0;
  double length_sum_ = 0.0;
  double more_length_ = 0.0;  ///< scale - 1
  Foretold headings_;
  Foretold lengths_;
};

}  // namespace roomatlas
