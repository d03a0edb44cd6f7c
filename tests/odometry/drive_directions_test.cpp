// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/drive_directions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "roomatlas/simulate/explore.hpp"
#include "roomatlas/simulate/random_world.hpp"
#include "roomatlas/simulate/tour.hpp"
#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

std::vector<test::WallLine> room() {
  return test::walls_along({{0, 0}, {5, 0}, {5, 3.5}, {3, 3.5}, {3, 3}, {0, 3}}, true);
}

/// Forth, a stop, and back; odometry reports the way back with a sign, or as forwards.
std::vector<RangeReading> there_and_back(bool reported_forwards) {
  std::vector<Pose2> truth;
  const auto at = [&](double x) { truth.push_back({x, 1.5, 0.2}); };
  for (int k = 0; k <= 15; ++k) at(1.5 + 0.1 * k);
  for (int k = 0; k < 5; ++k) at(3.0);
  for (int k = 1; k <= 15; ++k) at(3.0 - 0.1 * k);
  for (Pose2& pose : truth) {
    const double way = pose.x_m - 1.5;
    pose = Pose2{1.5, 1.5, 0.2} * Pose2{way, 0.0, 0.0};
  }
  auto readings = test::readings_along(room(), truth, 0.0);
  if (!reported_forwards) return readings;
  Pose2 odometry = truth.front();
  for (std::size_t i = 1; i < truth.size(); ++i) {
    Pose2 step = inverse(truth[i - 1]) * truth[i];
    step.x_m = std::abs(step.x_m);
    odometry = odometry * step;
    readings[i].odom_from_robot = odometry;
  }
  return readings;
}

TEST(DriveDirections, FindsTheDriveThatWasReportedTheWrongWayRound) {
  const auto directions = find_drive_directions(there_and_back(true), {});
  EXPECT_EQ(directions.drives_reversed, 1);
  EXPECT_FALSE(directions.odometry_is_signed);
  ASSERT_EQ(directions.of_step.size(), 36U);
  for (std::size_t i = 1; i <= 15; ++i)
    EXPECT_EQ(directions.of_step[i], DriveDirection::as_reported) << i;
  for (std::size_t i = 21; i < 36; ++i)
    EXPECT_EQ(directions.of_step[i], DriveDirection::reversed) << i;
}

TEST(DriveDirections, BelievesOdometryThatReportsBackwardSteps) {
  const auto directions = find_drive_directions(there_and_back(false), {});
  EXPECT_TRUE(directions.odometry_is_signed);
  EXPECT_EQ(directions.drives_reversed, 0);
}

TEST(DriveDirections, CallsADriveWithoutReturnsUndecided) {
  auto readings = there_and_back(true);
  for (RangeReading& reading : readings) {
    std::fill(reading.ranges_m.begin(), reading.ranges_m.end(), 5.0F);
  }
  const auto directions = find_drive_directions(readings, {});
  EXPECT_EQ(directions.drives_reversed, 0);
  EXPECT_EQ(directions.of_step.back(), DriveDirection::undecided);
  EXPECT_NEAR(directions.undecided_m.back(), 3.0, 1e-6);
}

/// Eight sonars that look ahead, in a hall: a robot that drives forwards alone, and turns on the
/// spot.
std::vector<RangeReading> tour_of_a_hall() {
  const FloorPlan hall = random_world({20474, RandomWorldKind::hall, 9});
  SimulationOptions robot;
  robot.sonars = 8;
  robot.sonar_cone_deg = 24.0;
  robot.odometry.length_share = -0.039;
  robot.odometry.heading_bias_deg_per_m = -0.5;
  const Drive drive = tour(hall, default_start(hall, robot.footprint).position(), {});
  std::vector<RangeReading> readings;
  simulate(hall, driven_within(drive, 240.0, robot), robot,
           [&](const SimulatedStep& step) { readings.push_back(step.reading); });
  return readings;
}

TEST(DriveDirections, ALongDriveWhosePairsSayLittleEachIsUndecided) {
  const std::vector<RangeReading> readings = tour_of_a_hall();
  DriveDirectionOptions summed;
  summed.mission.clear_log_odds_per_pair = 0.0;
  EXPECT_GT(find_drive_directions(readings, summed).drives_reversed, 0);
  DriveDirectionOptions alone;
  alone.mission.forward_drives = 1000;
  const DriveDirections directions = find_drive_directions(readings, alone);
  EXPECT_EQ(directions.drives_reversed, 0);
  EXPECT_GT(directions.undecided_m.back(), 1.0);
}

TEST(DriveDirections, ARobotThatClearlyDrivesForwardsDoesSoWhereNothingTells) {
  const DriveDirections directions = find_drive_directions(tour_of_a_hall(), {});
  EXPECT_EQ(directions.drives_reversed, 0);
  EXPECT_EQ(directions.undecided_m.back(), 0.0);
}

/// One mission behind the other.
std::vector<RangeReading> joined(std::vector<RangeReading> first,
                                 const std::vector<RangeReading>& then) {
  const Pose2 moved = first.back().odom_from_robot * inverse(then.front().odom_from_robot);
  const double later_s = first.back().timestamp_s + 0.2 - then.front().timestamp_s;
  for (RangeReading reading : then) {
    reading.odom_from_robot = moved * reading.odom_from_robot;
    reading.timestamp_s += later_s;
    first.push_back(reading);
  }
  return first;
}

/// With returns of the sonar that looks ahead alone.
std::vector<RangeReading> with_one_beam(std::vector<RangeReading> readings) {
  for (RangeReading& reading : readings) {
    for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
      if (i != 4) reading.ranges_m[i] = 5.0F;
    }
  }
  return readings;
}

TEST(DriveDirections, AnUnclearOneIsReversedWhereMoreAreClear) {
  const std::vector<RangeReading> clear = there_and_back(true);
  const std::vector<RangeReading> unclear = with_one_beam(clear);
  DriveDirectionOptions between;
  between.mission.clear_log_odds_per_pair = 0.6;
  EXPECT_EQ(find_drive_directions(unclear, between).drives_reversed, 0);
  EXPECT_EQ(find_drive_directions(joined(clear, unclear), between).drives_reversed, 1);
  EXPECT_EQ(find_drive_directions(joined(clear, joined(clear, unclear)), between).drives_reversed,
            3);
}

TEST(DriveDirections, TurnRoundTheTranslationOfAReversedStepAlone) {
  const Pose2 step{0.3, 0.1, 0.2};
  EXPECT_EQ(driven(step, DriveDirection::as_reported).x_m, 0.3);
  EXPECT_EQ(driven(step, DriveDirection::undecided).x_m, 0.3);
  const Pose2 back = driven(step, DriveDirection::reversed);
  EXPECT_EQ(back.x_m, -0.3);
  EXPECT_EQ(back.y_m, -0.1);
  EXPECT_EQ(back.theta_rad, 0.2);
}

TEST(DriveDirections, OfNothingAreNone) {
  EXPECT_TRUE(find_drive_directions({}, {}).of_step.empty());
}

}  // namespace
}  // namespace roomatlas
