// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/simulated.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

using namespace testing_simulate;
using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const FloorPlan& world, const Drive& drive) {
  try {
    run(world, drive, exact());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Drive, TruthStartsAtTheFirstWayPointLookingAlongTheFirstLegAndEndsAtTheLast) {
  const auto steps = run({}, {{1, 1}, {1, 3}, {4, 3}}, exact());
  EXPECT_EQ(steps.front().truth.world_from_robot, (Pose2{1, 1, kPi / 2}));
  EXPECT_NEAR(steps.back().truth.world_from_robot.x_m, 4.0, 1e-12);
  EXPECT_NEAR(steps.back().truth.world_from_robot.y_m, 3.0, 1e-12);
  EXPECT_NEAR(steps.back().truth.world_from_robot.theta_rad, 0.0, 1e-12);
}

TEST(Drive, IsTimedBySpeedAndTurnRate) {
  SimulationOptions options = exact();  // 5 m at 0.4 m/s, 90 degrees at 45 degrees/s: 14.5 s
  const auto steps = run({}, {{1, 1}, {1, 3}, {4, 3}}, options);
  ASSERT_EQ(steps.size(), 146U);
  EXPECT_EQ(steps.front().truth.timestamp_s, 1e9);
  EXPECT_NEAR(steps.back().truth.timestamp_s, 1e9 + 14.5, 1e-6);
  EXPECT_NEAR(steps[25].odometry.speed_m_per_s, 0.4, 1e-9);
  EXPECT_NEAR(steps[60].odometry.speed_m_per_s, 0.0, 1e-9);
  EXPECT_NEAR(degrees(steps[60].odometry.turn_rate_rad_per_s), -45.0, 1e-9);
}

TEST(Drive, TurnsOnTheSpotTheShorterWay) {
  const Drive drive = {{0, 0}, {2, 0}, {0, -0.5}};
  for (const SimulatedStep& step : run({}, drive, exact())) {
    const Point2 robot = step.truth.world_from_robot.position();
    EXPECT_LT(std::min(distance(Segment2{drive[0], drive[1]}, robot),
                       distance(Segment2{drive[1], drive[2]}, robot)),
              1e-9);
    EXPECT_LE(step.odometry.turn_rate_rad_per_s, 1e-12);
  }
}

TEST(Drive, EveryPartOfAStepHasTheSameTimestamp) {
  for (const SimulatedStep& step : run(square_room(), {{1, 1}, {3, 3}}, exact())) {
    EXPECT_EQ(step.odometry.timestamp_s, step.reading.timestamp_s);
    EXPECT_EQ(step.odometry.timestamp_s, step.truth.timestamp_s);
    EXPECT_EQ(step.odometry.odom_from_robot, step.reading.odom_from_robot);
  }
}

TEST(Drive, RepeatedWayPointsChangeNothing) {
  const auto once = run({}, {{0, 0}, {1, 0}, {1, 1}}, exact());
  const auto twice = run({}, {{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 1}}, exact());
  ASSERT_EQ(once.size(), twice.size());
  EXPECT_EQ(once.back().truth.world_from_robot, twice.back().truth.world_from_robot);
}

TEST(Drive, ThroughAWallIsRefusedNamingTheLeg) {
  EXPECT_THAT(refusal(square_room(), {{1, 1}, {3, 1}, {3, 6}}),
              AllOf(HasSubstr("leg 2 from (3.00, 1.00) to (3.00, 6.00)"),
                    HasSubstr("passes through a wall"), HasSubstr("clearance 0.00 m")));
}

TEST(Drive, TooNearToAWallIsRefusedNamingTheClearance) {
  EXPECT_THAT(
      refusal(square_room(), {{1, 1}, {3.85, 1}}),
      AllOf(HasSubstr("leg 1"), HasSubstr("within 0.15 m of a wall"), HasSubstr("needs 0.20 m")));
  EXPECT_EQ(refusal(square_room(), {{1, 1}, {3.79, 1}}), "no error");
}

TEST(Drive, ThroughFurnitureIsRefused) {
  FloorPlan world = square_room();
  world.furniture = {{{box(2, 2, 3, 3), {}}, FurnitureKind::free_standing}};
  EXPECT_THAT(refusal(world, {{1, 1}, {3.5, 3.5}}), HasSubstr("passes through furniture"));
}

TEST(Drive, InsideAWallBodyIsRefused) {
  FloorPlan world;
  world.walls = {{box(0, 0, 10, 10), {}}};
  EXPECT_THAT(refusal(world, {{5, 5}, {6, 5}}), HasSubstr("passes through a wall"));
}

TEST(Drive, NeedsTwoDifferentFiniteWayPoints) {
  EXPECT_THAT(refusal({}, {}), HasSubstr("two different way-points"));
  EXPECT_THAT(refusal({}, {{1, 1}}), HasSubstr("two different way-points"));
  EXPECT_THAT(refusal({}, {{1, 1}, {1, 1}}), HasSubstr("two different way-points"));
  EXPECT_THAT(refusal({}, {{1, 1}, {std::numeric_limits<double>::quiet_NaN(), 1}}),
              HasSubstr("way-point 2 is not finite"));
}

TEST(Drive, OptionsThatMakeNoSenseAreUsageErrors) {
  const auto attempt = [](auto change) {
    SimulationOptions options;
    change(options);
    run({}, {{0, 0}, {1, 0}}, options);
  };
  EXPECT_NO_THROW(attempt([](SimulationOptions&) {}));
  EXPECT_THROW(attempt([](auto& o) { o.speed_m_per_s = 0.0; }), UsageError);
  EXPECT_THROW(attempt([](auto& o) { o.rate_hz = -1.0; }), UsageError);
  EXPECT_THROW(attempt([](auto& o) { o.sonar.dropout_share = 1.5; }), UsageError);
  EXPECT_THROW(attempt([](auto& o) { o.sonar.range_noise_m = -0.1; }), UsageError);
  EXPECT_THROW(
      attempt([](auto& o) { o.turn_rate_deg_per_s = std::numeric_limits<double>::quiet_NaN(); }),
      UsageError);
}

}  // namespace
}  // namespace roomatlas
