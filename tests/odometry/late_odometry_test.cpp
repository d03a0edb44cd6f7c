// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/late_odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {
namespace {

/// Along a circle of 2 m radius, at 0.5 rad/s.
Pose2 truth(double time_s) {
  const double angle_rad = 0.5 * time_s;
  return {2.0 * std::sin(angle_rad), 2.0 * (1.0 - std::cos(angle_rad)), wrap_angle(angle_rad)};
}

std::vector<DeadReckoned> given(double odometry_lag_s, double told_lag_s) {
  LateOdometry late;
  std::vector<DeadReckoned> out;
  const auto take = [&] {
    while (auto next = late.next(told_lag_s)) out.push_back(*next);
  };
  for (int i = 0; i < 100; ++i) {
    DeadReckoned one;
    one.reading.timestamp_s = 0.1 * i;
    one.reckoned_from_robot = truth(one.reading.timestamp_s - odometry_lag_s);
    late.add(one);
    take();
  }
  late.finish();
  take();
  return out;
}

TEST(LateOdometry, GivesEachReadingTheStepThatWasReportedLater) {
  for (const double lag_s : {-0.25, 0.0, 0.1, 0.33}) {
    const auto readings = given(lag_s, lag_s);
    ASSERT_EQ(readings.size(), 100U);
    for (std::size_t i = 5; i + 5 < readings.size(); ++i) {
      const double time_s = readings[i].reading.timestamp_s;
      const Pose2 step =
          inverse(readings[i - 1].reckoned_from_robot) * readings[i].reckoned_from_robot;
      const Pose2 driven = inverse(truth(time_s - 0.1)) * truth(time_s);
      EXPECT_NEAR(step.x_m, driven.x_m, 1e-3);
      EXPECT_NEAR(step.y_m, driven.y_m, 2e-3);
      EXPECT_NEAR(step.theta_rad, driven.theta_rad, 1e-6);
    }
  }
}

TEST(LateOdometry, ChangesNothingWithoutALag) {
  for (const DeadReckoned& one : given(0.2, 0.0)) {
    const Pose2 as_added = truth(one.reading.timestamp_s - 0.2);
    EXPECT_EQ(one.reckoned_from_robot.x_m, as_added.x_m);
    EXPECT_EQ(one.reckoned_from_robot.theta_rad, as_added.theta_rad);
  }
}

TEST(LateOdometry, WaitsForTheOdometryThatAReadingNeeds) {
  LateOdometry late;
  EXPECT_FALSE(late.next(0.0));
  for (const double time_s : {0.0, 0.1, 0.2}) {
    DeadReckoned one;
    one.reading.timestamp_s = time_s;
    late.add(one);
  }
  EXPECT_FALSE(late.next(0.25));
  EXPECT_TRUE(late.next(0.15));
  EXPECT_FALSE(late.next(0.15));
  late.finish();
  EXPECT_TRUE(late.next(0.15));
}

}  // namespace
}  // namespace roomatlas
