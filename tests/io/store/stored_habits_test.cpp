// SPDX-License-Identifier: GPL-3.0-or-later
#include "store/stored_habits.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace roomatlas {
namespace {

TEST(StoredHabits, HaveTheSignsOfWhatOdometryDoesWrong) {
  OdometryHabits habits;
  habits.bias_rad_per_m = 0.02;  // odometry turns the path right: to be turned left
  habits.turn_gain = 0.96;       // turns are reported too large
  EXPECT_EQ(stored(habits).drift_rad_per_m, -0.02);
  EXPECT_EQ(stored(habits).turns_more_per_rad, 0.04);
}

TEST(StoredHabits, AreZeroWithoutASignWhereThereAreNone) {
  const StoredHabits none = stored(OdometryHabits());
  EXPECT_EQ(none.drift_rad_per_m, 0.0);
  EXPECT_FALSE(std::signbit(none.drift_rad_per_m));
  EXPECT_FALSE(std::signbit(none.turns_more_per_rad));
}

TEST(StoredHabits, ComeBackAsTheyWere) {
  for (const double gain : {0.93, 0.96, 1.0, 1.01, 1.07}) {
    OdometryHabits habits;
    habits.bias_rad_per_m = -0.013;
    habits.turn_gain = gain;
    const OdometryHabits back = habits_of(stored(habits));
    EXPECT_EQ(back.bias_rad_per_m, habits.bias_rad_per_m);
    EXPECT_NEAR(back.turn_gain, habits.turn_gain, 1e-15);
  }
}

}  // namespace
}  // namespace roomatlas
