// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/simulate/explore.hpp"
#include "simulate/simulated.hpp"

namespace roomatlas {
namespace {

using namespace testing_simulate;

const Drive kLong = {{3, 4}, {503, 4}};

SimulationOptions fast() {
  SimulationOptions options = exact();
  options.speed_m_per_s = 2.0;
  return options;
}

TEST(OdometryFaults, SlipsLengthenTheGivenShareOfTheDriveByHalf) {
  SimulationOptions options = fast();
  options.faults.slip_share = 0.1;
  double longer_m = 0.0;
  constexpr int kRuns = 40;
  for (int seed = 0; seed < kRuns; ++seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    Pose2 before;
    for (const SimulatedStep& step : run({}, kLong, options)) {
      const Pose2 now = step.odometry.odom_from_robot;
      longer_m += (inverse(before) * now).position().norm();
      before = now;
    }
  }
  // 500 m, of which a tenth is reported half as long again: about 100 slips a run, whose number has
  // a standard deviation of 10, and each adds 0.25 m.
  EXPECT_NEAR(longer_m / kRuns, 525.0, 4.0 * 2.5 / std::sqrt(kRuns));
}

TEST(OdometryFaults, ASlipTurnsTheReportedHeadingAndNoSlipDoesNot) {
  SimulationOptions options = fast();
  options.faults.slip_share = 0.1;
  const auto steps = run({}, kLong, options);
  EXPECT_GT(std::abs(steps.back().odometry.odom_from_robot.theta_rad), radians(0.1));
}

TEST(OdometryFaults, LagReportsThePoseOfEarlier) {
  SimulationOptions options = fast();
  const Drive drive = {{0, 0}, {6, 0}, {6, 6}};
  const auto now = run({}, drive, options);
  options.faults.lag_s = 0.3;
  const auto late = run({}, drive, options);
  ASSERT_EQ(late.size(), now.size());
  for (std::size_t i = 3; i < now.size(); ++i) {
    const Pose2& expected = now[i - 3].odometry.odom_from_robot;
    EXPECT_NEAR(late[i].odometry.odom_from_robot.x_m, expected.x_m, 1e-6);
    EXPECT_NEAR(late[i].odometry.odom_from_robot.y_m, expected.y_m, 1e-6);
    EXPECT_EQ(late[i].reading.odom_from_robot, late[i].odometry.odom_from_robot);
    EXPECT_EQ(late[i].truth.world_from_robot, now[i].truth.world_from_robot);
  }
  options.faults.lag_s = 0.25;  // between two periods
  const auto between = run({}, drive, options);
  EXPECT_NEAR(between[10].odometry.odom_from_robot.x_m,
              (now[7].odometry.odom_from_robot.x_m + now[8].odometry.odom_from_robot.x_m) / 2.0,
              1e-6);
}

TEST(OdometryFaults, AnEncoderThatCountsNothingTurnsTheReportedHeadingAboutItsWheel) {
  SimulationOptions options = fast();
  options.faults.dropouts_per_hour = 240.0;
  options.faults.dropout_s = 0.5;
  const auto steps = run({}, kLong, options);
  // In 0.5 s at 2 m/s a wheel of a track of 0.4 m makes 1 m alone: 2.5 rad, and half the length.
  int failed = 0;
  double turned_rad = 0.0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const Pose2 step =
        inverse(steps[i - 1].odometry.odom_from_robot) * steps[i].odometry.odom_from_robot;
    if (std::abs(step.theta_rad) < 1e-9) {
      EXPECT_NEAR(step.x_m, 0.2, 1e-9);
      continue;
    }
    ++failed;
    turned_rad += std::abs(step.theta_rad);
    EXPECT_NEAR(std::abs(step.theta_rad), 0.2 / 0.4, 1e-9);
    EXPECT_NEAR(steps[i].odometry.speed_m_per_s, 1.0, 1e-9);
  }
  EXPECT_EQ(failed % 5, 0);
  EXPECT_NEAR(turned_rad, failed / 5 * 2.5, 1e-6);
  // 250 s at four a minute: about 17.
  EXPECT_GE(failed / 5, 6);
  EXPECT_LE(failed / 5, 35);
}

TEST(OdometryFaults, APushMovesTheRobotAndNotItsOdometry) {
  SimulationOptions options = fast();
  options.speed_m_per_s = 0.4;
  options.faults.pushes_per_hour = 200.0;
  options.faults.push_m = 0.3;
  options.faults.push_deg = 20.0;
  const auto steps = run({}, {{0, 0}, {100, 0}}, options);
  int pushes = 0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const Pose2 truth =
        inverse(steps[i - 1].truth.world_from_robot) * steps[i].truth.world_from_robot;
    const Pose2 reported =
        inverse(steps[i - 1].odometry.odom_from_robot) * steps[i].odometry.odom_from_robot;
    EXPECT_LE(reported.position().norm(), 0.04 + 1e-9);
    const double unnoticed_m = (truth.position() - reported.position()).norm();
    const double unnoticed_deg =
        std::abs(degrees(wrap_angle(truth.theta_rad - reported.theta_rad)));
    if (unnoticed_m < 1e-6 && unnoticed_deg < 1e-6) continue;
    ++pushes;
    EXPECT_LE(unnoticed_m, 0.3 + 0.04);
    EXPECT_LE(unnoticed_deg, 20.0 + 1e-6);
  }
  EXPECT_GE(pushes, 5);  // 250 s and the ways back at 200 an hour: about 14
  EXPECT_LE(pushes, 40);
  // It drives on to the end of the drive.
  EXPECT_NEAR(steps.back().truth.world_from_robot.x_m, 100.0, 0.2);
  EXPECT_NEAR(steps.back().truth.world_from_robot.y_m, 0.0, 0.31);
}

TEST(OdometryFaults, APushedRobotStaysClearOfWalls) {
  SimulationOptions options = fast();
  options.speed_m_per_s = 0.4;
  options.faults.pushes_per_hour = 1000.0;
  const auto steps = run(square_room(), {{1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}}, options);
  for (const SimulatedStep& step : steps) {
    const Point2 at = step.truth.world_from_robot.position();
    EXPECT_GE(at.minCoeff(), 0.25);
    EXPECT_LE(at.maxCoeff(), 3.75);
  }
}

TEST(OdometryFaults, RatesThatMakeNoSenseAreRefused) {
  SimulationOptions options = fast();
  options.faults.lag_s = -0.1;
  EXPECT_THROW((void)run({}, kLong, options), UsageError);
  options.faults = {};
  options.faults.slip_share = std::nan("");
  EXPECT_THROW((void)run({}, kLong, options), UsageError);
}

TEST(DrivenWithin, EndsAtTheLastWayPointThatIsReachedInTime) {
  SimulationOptions options = exact();  // 0.4 m/s, 45 degrees a second
  const Drive drive = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(driven_within(drive, 1000.0, options).size(), 4U);
  EXPECT_EQ(driven_within(drive, 10.0 + 2.0 + 10.0 + 0.01, options).size(), 3U);
  EXPECT_EQ(driven_within(drive, 10.0 + 2.0 + 9.9, options).size(), 2U);
  EXPECT_EQ(driven_within(drive, 1.0, options).size(), 2U);
}

}  // namespace
}  // namespace roomatlas
