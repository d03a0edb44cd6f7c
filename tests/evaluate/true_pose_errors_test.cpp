// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "roomatlas/evaluate/evaluate.hpp"

namespace roomatlas {
namespace {

/// A circle of 2 m radius, driven at 0.1 rad/s.
Pose2 on_circle(double time_s) {
  const double angle = 0.1 * time_s;
  return {2.0 * std::cos(angle), 2.0 * std::sin(angle), wrap_angle(angle + kPi / 2.0)};
}

Trajectory circle(double from_s, double step_s, int count) {
  Trajectory drive;
  for (int i = 0; i < count; ++i) {
    const double time_s = from_s + step_s * i;
    drive.push_back({time_s, on_circle(time_s)});
  }
  return drive;
}

void move(Trajectory& drive, const Pose2& other_from_map) {
  for (StampedPose& stamped : drive) stamped.pose = other_from_map * stamped.pose;
}

TEST(TruePoseErrors, AreZeroForATrajectoryThatOnlyStartsElsewhere) {
  const Trajectory truth = circle(0.0, 0.5, 100);
  const Pose2 building_from_truth{-7, 3, -2.5};
  Trajectory drive = truth;
  move(drive, building_from_truth);
  const TruePoseErrors errors = true_pose_errors(drive, truth);
  EXPECT_EQ(errors.poses, 100);
  EXPECT_EQ(errors.matched, 100);
  EXPECT_LT(errors.position_m.maximum, 1e-12);
  EXPECT_LT(errors.heading_deg.maximum, 1e-9);
  const Pose2 unity = errors.truth_from_building * building_from_truth;
  EXPECT_NEAR(unity.position().norm(), 0.0, 1e-12);
  EXPECT_NEAR(unity.theta_rad, 0.0, 1e-12);
}

TEST(TruePoseErrors, OfADriveThatIsTurnedAfterItsStartAreTheChords) {
  // Straight on along x; from the second pose on the estimate is turned by 90 degrees.
  const Trajectory truth = {{0, {0, 0, 0}}, {1, {1, 0, 0}}, {2, {2, 0, 0}}};
  const Trajectory drive = {{0, {0, 0, 0}}, {1, {0, 1, kPi / 2}}, {2, {0, 2, kPi / 2}}};
  const TruePoseErrors errors = true_pose_errors(drive, truth);
  EXPECT_NEAR(errors.position_m.mean, (0.0 + std::sqrt(2.0) + 2.0 * std::sqrt(2.0)) / 3.0, 1e-12);
  EXPECT_NEAR(errors.heading_deg.mean, 60.0, 1e-9);
  ASSERT_EQ(errors.errors.size(), 3U);
  EXPECT_NEAR(errors.errors[1].position_m, std::sqrt(2.0), 1e-12);
  EXPECT_EQ(errors.errors[2].timestamp_s, 2.0);
  EXPECT_LT(errors.fitted_position_m.maximum, 1e-9);  // a straight drive all the same
  EXPECT_NEAR(errors.heading_deg.median, 90.0, 1e-9);
}

TEST(TruePoseErrors, InterpolateBetweenTruePoses) {
  const Trajectory truth = {{0, {0, 0, 3.0}}, {1, {2, 0, -3.0}}};
  const Pose2 half_way{1, 0, -kPi};  // the shorter arc from 3 to -3 goes over pi
  const Pose2 quarter{0.5, 0, wrap_angle(3.0 + (2.0 * kPi - 6.0) / 4.0)};
  const TruePoseErrors errors = true_pose_errors({{0.25, quarter}, {0.5, half_way}}, truth);
  EXPECT_EQ(errors.matched, 2);
  EXPECT_LT(errors.position_m.maximum, 1e-12);
  EXPECT_LT(errors.heading_deg.maximum, 1e-9);
}

TEST(TruePoseErrors, LeavePosesOutsideTheTruthUnmatched) {
  const Trajectory truth = circle(10.0, 1.0, 11);
  const TruePoseErrors errors = true_pose_errors(circle(0.0, 0.5, 100), truth);
  EXPECT_EQ(errors.poses, 100);
  EXPECT_EQ(errors.matched, 21);  // 10, 10.5 ... 20
  EXPECT_LT(errors.position_m.maximum, 0.01);
}

TEST(TruePoseErrors, FollowTruthAndTrajectoryThroughAStepBackInTime) {
  // The clock steps back by 1 s after the third pose; the robot goes on at 1 m/s.
  const Trajectory truth = {{0, {0, 0, 0}},   {1, {1, 0, 0}},   {2, {2, 0, 0}},
                            {1.5, {3, 0, 0}}, {2.5, {4, 0, 0}}, {3.5, {5, 0, 0}}};
  const TruePoseErrors same = true_pose_errors(truth, truth);
  EXPECT_EQ(same.matched, 6);
  EXPECT_DOUBLE_EQ(same.position_m.maximum, 0.0);
  // Between the poses too: 1.75 occurs before the step (at 1.75 m) and after it (at 3.25 m).
  const Trajectory between = {{0.5, {0.5, 0, 0}},
                              {1.75, {1.75, 0, 0}},
                              {1.6, {3.1, 0, 0}},
                              {1.75, {3.25, 0, 0}},
                              {3.0, {4.5, 0, 0}}};
  const TruePoseErrors errors = true_pose_errors(between, truth);
  EXPECT_EQ(errors.matched, 5);
  EXPECT_LT(errors.position_m.maximum, 1e-12);
}

TEST(TruePoseErrors, AgreeWithASearchOfAllIntervals) {
  const Trajectory truth = circle(0.0, 0.7, 60);
  Trajectory drive = circle(0.0, 0.31, 120);
  for (std::size_t i = 0; i < drive.size(); ++i) drive[i].pose.x_m += 0.01 * static_cast<double>(i);
  std::vector<double> expected_m;
  for (const auto& [time_s, pose] : drive) {
    for (std::size_t k = 0; k + 1 < truth.size(); ++k) {
      const double from_s = truth[k].timestamp_s;
      const double to_s = truth[k + 1].timestamp_s;
      if (time_s < from_s || time_s > to_s) continue;
      const Pose2 true_pose =
          interpolate(truth[k].pose, truth[k + 1].pose, (time_s - from_s) / (to_s - from_s));
      expected_m.push_back((true_pose.position() - pose.position()).norm());
      break;
    }
  }
  const TruePoseErrors errors = true_pose_errors(drive, truth);
  EXPECT_EQ(errors.matched, std::ssize(expected_m));
  EXPECT_NEAR(errors.position_m.mean, statistics(expected_m).mean, 1e-12);
  EXPECT_NEAR(errors.position_m.maximum, statistics(expected_m).maximum, 1e-12);
}

TEST(TruePoseErrors, OfNothingAreNaNAndDoNotAlign) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Trajectory drive = circle(0.0, 1.0, 5);
  for (const TruePoseErrors& errors :
       {true_pose_errors({}, drive), true_pose_errors(drive, {}), true_pose_errors({}, {}),
        true_pose_errors({{nan, {}}}, drive), true_pose_errors(drive, {{nan, {}}})}) {
    EXPECT_EQ(errors.matched, 0);
    EXPECT_EQ(errors.position_m.count, 0);
    EXPECT_TRUE(std::isnan(errors.position_m.mean));
    EXPECT_EQ(errors.truth_from_building, Pose2{});
  }
}

TEST(TruePoseErrors, MatchASingleTruePoseAtItsOwnTimestamp) {
  EXPECT_EQ(true_pose_errors(circle(0.0, 1.0, 5), {{3.0, {}}}).matched, 1);
}

}  // namespace
}  // namespace roomatlas
