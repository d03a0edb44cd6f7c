// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/simulated.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace roomatlas {
namespace {

using namespace testing_simulate;

SimulationOptions fast_drive() {
  SimulationOptions options = exact();
  options.speed_m_per_s = 5.0;
  return options;
}

const Drive kHundredMetres = {{3, 4}, {103, 4}};
/// 200 m in 20 legs with turns both ways.
Drive zigzag() {
  Drive drive = {{0, 0}};
  for (int leg = 0; leg < 20; ++leg) {
    drive.push_back(drive.back() + (leg % 2 == 0 ? Point2(6, 8) : Point2(10, 0)));
  }
  return drive;
}

TEST(Odometry, StartsAtItsOwnOriginWhereverTheRobotStands) {
  const auto steps = run({}, {{3, 4}, {3, 9}}, exact());
  EXPECT_EQ(steps.front().odometry.odom_from_robot, Pose2());
  EXPECT_EQ(steps.front().reading.odom_from_robot, Pose2());
  EXPECT_EQ(steps.front().odometry.speed_m_per_s, 0.0);
}

TEST(Odometry, WithoutErrorsIsTheTruthInTheFrameOfTheStart) {
  const auto steps = run({}, zigzag(), fast_drive());
  const Pose2 start_from_world = inverse(steps.front().truth.world_from_robot);
  for (const SimulatedStep& step : steps) {
    const Pose2 expected = start_from_world * step.truth.world_from_robot;
    EXPECT_NEAR(step.odometry.odom_from_robot.x_m, expected.x_m, 1e-9);
    EXPECT_NEAR(step.odometry.odom_from_robot.y_m, expected.y_m, 1e-9);
    EXPECT_NEAR(wrap_angle(step.odometry.odom_from_robot.theta_rad - expected.theta_rad), 0.0,
                1e-9);
  }
}

TEST(Odometry, ReportsLengthsLongerByTheGivenShare) {
  SimulationOptions options = fast_drive();
  options.odometry.length_share = 0.02;
  const auto steps = run({}, kHundredMetres, options);
  EXPECT_NEAR(steps.back().odometry.odom_from_robot.x_m, 102.0, 1e-9);
  EXPECT_NEAR(steps.back().odometry.odom_from_robot.y_m, 0.0, 1e-9);
  EXPECT_NEAR(steps[5].odometry.speed_m_per_s, 5.1, 1e-9);
}

TEST(Odometry, HeadingDriftsByTheBiasOverLengthAndNotOverTurns) {
  SimulationOptions options = fast_drive();
  options.odometry.heading_bias_deg_per_m = 0.1;
  const auto straight = run({}, kHundredMetres, options);
  EXPECT_NEAR(degrees(straight.back().odometry.odom_from_robot.theta_rad), 10.0, 1e-9);
  // An arc of 100 m that bends by 10 degrees.
  const double radius_m = 100.0 / radians(10.0);
  EXPECT_NEAR(straight.back().odometry.odom_from_robot.x_m, radius_m * std::sin(radians(10)), 1e-3);
  EXPECT_NEAR(straight.back().odometry.odom_from_robot.y_m, radius_m * (1 - std::cos(radians(10))),
              1e-3);

  const auto turning = run({}, zigzag(), options);
  const Pose2 truth =
      inverse(turning.front().truth.world_from_robot) * turning.back().truth.world_from_robot;
  EXPECT_NEAR(
      degrees(wrap_angle(turning.back().odometry.odom_from_robot.theta_rad - truth.theta_rad)),
      20.0, 1e-6);
}

TEST(Odometry, ReportsTurnsLargerByTheGivenShare) {
  SimulationOptions options = fast_drive();
  options.odometry.turn_share = -0.04;
  const auto steps = run({}, {{0, 0}, {5, 0}, {5, 5}}, options);  // one turn of 90 degrees
  EXPECT_NEAR(degrees(steps.back().odometry.odom_from_robot.theta_rad), 90.0 * 0.96, 1e-9);
}

TEST(Odometry, HeadingNoiseIsARandomWalkOverLength) {
  SimulationOptions options = fast_drive();
  options.odometry.heading_noise_deg_per_sqrt_m = 0.5;
  constexpr int kRuns = 300;
  double sum_deg = 0.0;
  double half_way = 0.0;
  double whole_way = 0.0;
  for (int i = 0; i < kRuns; ++i) {
    options.seed = static_cast<std::uint64_t>(i);
    const auto steps = run({}, kHundredMetres, options);
    const auto heading_deg = [&](std::size_t step) {
      return degrees(steps[step].odometry.odom_from_robot.theta_rad);
    };
    sum_deg += heading_deg(steps.size() - 1);
    half_way += std::pow(heading_deg(steps.size() / 2), 2);
    whole_way += std::pow(heading_deg(steps.size() - 1), 2);
  }
  // Mean 0, variance 0.25 a metre; the variance of a sample variance is 2 / n of its square.
  const double relative = 4.0 * std::sqrt(2.0 / kRuns);
  EXPECT_NEAR(sum_deg / kRuns, 0.0, 4.0 * 5.0 / std::sqrt(kRuns));
  EXPECT_NEAR(half_way / kRuns, 12.5, 12.5 * relative);
  EXPECT_NEAR(whole_way / kRuns, 25.0, 25.0 * relative);
}

TEST(Odometry, NoiseDoesNotDependOnTheRate) {
  SimulationOptions options = fast_drive();
  options.odometry.heading_noise_deg_per_sqrt_m = 0.5;
  options.rate_hz = 2.0;
  constexpr int kRuns = 300;
  double variance = 0.0;
  for (int i = 0; i < kRuns; ++i) {
    options.seed = static_cast<std::uint64_t>(i);
    const auto steps = run({}, kHundredMetres, options);
    variance += std::pow(degrees(steps.back().odometry.odom_from_robot.theta_rad), 2) / kRuns;
  }
  EXPECT_NEAR(variance, 25.0, 25.0 * 4.0 * std::sqrt(2.0 / kRuns));
}

TEST(Odometry, ThePresetsAreWhatTheyAreSaidToBe) {
  const OdometryErrors mild = odometry_errors(OdometryPreset::mild);
  EXPECT_EQ(mild.length_share, 0.005);
  EXPECT_EQ(mild.heading_bias_deg_per_m, 0.1);
  EXPECT_EQ(mild.heading_noise_deg_per_sqrt_m, 1.0);
  const OdometryErrors typical = odometry_errors(OdometryPreset::typical);
  EXPECT_EQ(typical.length_share, 0.01);
  EXPECT_EQ(typical.heading_bias_deg_per_m, 0.3);
  EXPECT_EQ(typical.heading_noise_deg_per_sqrt_m, 2.0);
  EXPECT_GT(odometry_errors(OdometryPreset::hard).heading_bias_deg_per_m, 3.0);
}

}  // namespace
}  // namespace roomatlas
