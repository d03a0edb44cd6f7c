// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/habits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace roomatlas {
namespace {

constexpr OdometryHabits kTrue{0.0, radians(1.2), 0.96, 1.03};

/// What odometry with these habits reports of a true step: the inverse of `without_habits`.
Pose2 reported(const Pose2& step, const OdometryHabits& habits) {
  const double x_m = step.x_m / habits.length_scale;
  const double y_m = step.y_m / habits.length_scale;
  const double forwards_m = std::copysign(std::hypot(x_m, y_m), x_m);
  return {x_m, y_m, (step.theta_rad - habits.bias_rad_per_m * forwards_m) / habits.turn_gain};
}

void expect_near(const Pose2& a, const Pose2& b) {
  EXPECT_NEAR(a.x_m, b.x_m, 1e-12);
  EXPECT_NEAR(a.y_m, b.y_m, 1e-12);
  EXPECT_NEAR(a.theta_rad, b.theta_rad, 1e-12);
}

TEST(WithoutHabits, UndoesThem) {
  for (const Pose2& step : {Pose2{0.1, 0.0, 0.0}, Pose2{-0.2, 0.01, 0.1}, Pose2{0.0, 0.0, -0.4}}) {
    expect_near(without_habits(reported(step, kTrue), kTrue), step);
    expect_near(without_habits(step, {}), step);
  }
}

struct Drive {
  double noise_per_sqrt_m = radians(0.5);  ///< of odometry's heading
  double share_of_jumps = 0.0;
  bool is_length_seen = true;
  int steps = 3000;
};

/// A robot that drives straight, turns now and then, and sometimes backs up.
OdometryHabits learnt(const OdometryHabits& habits, const Drive& drive) {
  std::mt19937 engine(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  HabitLearner learner;
  for (int i = 0; i < drive.steps; ++i) {
    const bool turns = i % 40 < 8;
    const double way_m = i % 200 > 190 ? -0.05 : 0.1;
    const Pose2 step{turns ? 0.02 : way_m, 0.0, turns ? (i % 80 < 40 ? 0.15 : -0.11) : 0.0};
    Pose2 odometry = reported(step, habits);
    odometry.theta_rad +=
        drive.noise_per_sqrt_m * std::sqrt(step.position().norm()) * normal(engine);
    Pose2 matched = step;
    matched.theta_rad += radians(0.05) * normal(engine);
    if (uniform(engine) < drive.share_of_jumps) matched.theta_rad += radians(15.0);
    learner.add(odometry, matched, drive.is_length_seen);
  }
  return learner.habits();
}

TEST(HabitLearner, FindsTheHabitsOfADriftingOdometry) {
  const OdometryHabits found = learnt(kTrue, {});
  EXPECT_NEAR(degrees(found.bias_rad_per_m), degrees(kTrue.bias_rad_per_m), 0.1);
  EXPECT_NEAR(found.turn_gain, kTrue.turn_gain, 0.01);
  EXPECT_NEAR(found.length_scale, kTrue.length_scale, 0.003);
  EXPECT_EQ(found.lag_s, 0.0);
}

TEST(HabitLearner, BelievesOdometryThatHasNone) {
  const OdometryHabits found = learnt({}, {});
  EXPECT_NEAR(degrees(found.bias_rad_per_m), 0.0, 0.1);
  EXPECT_NEAR(found.turn_gain, 1.0, 0.01);
  EXPECT_NEAR(found.length_scale, 1.0, 0.002);
}

TEST(HabitLearner, IsNotMovedByMatchesThatJumped) {
  Drive drive;
  drive.share_of_jumps = 0.01;  // a tenth of the stretches
  const OdometryHabits found = learnt(kTrue, drive);
  EXPECT_NEAR(degrees(found.bias_rad_per_m), degrees(kTrue.bias_rad_per_m), 0.4);
  EXPECT_NEAR(found.turn_gain, kTrue.turn_gain, 0.02);
}

TEST(HabitLearner, SaysNothingOfLengthsThatNoWallShows) {
  Drive drive;
  drive.is_length_seen = false;
  const OdometryHabits found = learnt(kTrue, drive);
  EXPECT_EQ(found.length_scale, 1.0);
  EXPECT_NEAR(degrees(found.bias_rad_per_m), degrees(kTrue.bias_rad_per_m), 0.1);
}

TEST(HabitLearner, KnowsNothingAtFirstAndAfterInterruptionsOfEachStretch) {
  EXPECT_EQ(HabitLearner().habits(), OdometryHabits());
  HabitLearner learner;
  for (int i = 0; i < 1000; ++i) {
    learner.add({0.1, 0.0, 0.0}, {0.2, 0.0, 0.1}, true);
    if (i % 5 == 4) learner.interrupt();  // stretches of half a metre are never whole
  }
  EXPECT_EQ(learner.stretches(), 0);
  EXPECT_EQ(learner.habits(), OdometryHabits());
}

}  // namespace
}  // namespace roomatlas
