// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/room_localizer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include "match/swept_room.hpp"

namespace roomatlas {
namespace {

using namespace test;

/// Odometry that reports each step longer and each turn larger, and that drifts as it drives.
Pose2 reported(const Pose2& true_step) {
  return {1.02 * true_step.x_m, 1.02 * true_step.y_m,
          1.03 * true_step.theta_rad + radians(1.5) * true_step.position().norm()};
}

struct Drive {
  double worst_m = 0.0;
  double worst_deg = 0.0;
  double odometry_m = 0.0;  ///< off at the end
};

Drive localized(const std::vector<RangeReading>& readings, Localizer& localizer,
                std::size_t jump_at = 0) {
  Drive drive;
  Pose2 pose = readings.front().odom_from_robot;
  Pose2 odometry = pose;
  localizer.add(readings.front(), pose);
  for (std::size_t i = 1; i < readings.size(); ++i) {
    const Pose2& truth = readings[i].odom_from_robot;
    Pose2 step = reported(inverse(readings[i - 1].odom_from_robot) * truth);
    if (i == jump_at) step = step * Pose2{0.1, 0.1, radians(3.0)};
    pose = localizer.locate(readings[i], pose * step, step);
    odometry = odometry * step;
    drive.worst_m = std::max(drive.worst_m, (pose.position() - truth.position()).norm());
    drive.worst_deg = std::max(drive.worst_deg, turn_deg(pose, truth));
  }
  const Point2 end = readings.back().odom_from_robot.position();
  drive.odometry_m = (odometry.position() - end).norm();
  return drive;
}

/// Around the room, again and again.
std::vector<RangeReading> laps(int count, int beams = 180) {
  LaserRobot robot;
  robot.beams = beams;
  robot.noise_m = 0.01;
  Polyline way;
  for (int lap = 0; lap < count; ++lap) {
    for (const Point2& point : way_points_of(kUnevenRoom)) way.push_back(point);
  }
  return readings_along(surfaces_of(kUnevenRoom), way, robot);
}

TEST(RoomLocalizer, StaysWithTheTruthWhileOdometryDriftsAway) {
  RoomLocalizer localizer{LocalizeOptions{}};
  const Drive drive = localized(laps(2), localizer);
  EXPECT_GT(drive.odometry_m, 0.5);
  EXPECT_LT(drive.worst_m, 0.04);
  EXPECT_LT(drive.worst_deg, 1.0);
}

TEST(RoomLocalizer, HoldsByFewBeamsWhatTheirLastSweepsTellTogether) {
  const auto readings = laps(2, 24);
  RoomLocalizer localizer{LocalizeOptions{}};
  const Drive drive = localized(readings, localizer);
  EXPECT_GT(drive.odometry_m, 0.5);
  EXPECT_LT(drive.worst_m, 0.08);
  EXPECT_LT(drive.worst_deg, 2.0);
  LocalizeOptions alone;
  alone.recent.few_beams = 0;
  RoomLocalizer by_sweep{alone};
  EXPECT_GT(localized(readings, by_sweep).worst_m, 0.3);
}

TEST(RoomLocalizer, LearnsTheHabitsOfOdometry) {
  RoomLocalizer localizer{LocalizeOptions{}};
  EXPECT_FALSE(localizer.habits());
  (void)localized(laps(4), localizer);
  ASSERT_TRUE(localizer.habits());
  EXPECT_NEAR(degrees(localizer.habits()->bias_rad_per_m), -1.5 / 1.02, 0.4);
  EXPECT_NEAR(localizer.habits()->turn_gain, 1.0 / 1.03, 0.015);
  EXPECT_NEAR(localizer.habits()->length_scale, 1.0 / 1.02, 0.008);
}

TEST(RoomLocalizer, LearnsLengthsFromFewBeamsToo) {
  const auto readings = laps(4, 24);
  RoomLocalizer localizer{LocalizeOptions{}};
  (void)localized(readings, localizer);
  ASSERT_TRUE(localizer.habits());
  EXPECT_NEAR(localizer.habits()->length_scale, 1.0 / 1.02, 0.012);
  LocalizeOptions as_of_many;
  as_of_many.min_across_of_few = as_of_many.min_across;
  RoomLocalizer deaf{as_of_many};
  (void)localized(readings, deaf);
  ASSERT_TRUE(deaf.habits());
  EXPECT_NEAR(deaf.habits()->length_scale, 1.0, 1e-9);  // nothing was learnt of them
}

TEST(RoomLocalizer, FindsTheRobotAgainAfterAJumpOfOdometry) {
  const auto readings = laps(1);
  RoomLocalizer localizer{LocalizeOptions{}};
  const Drive drive = localized(readings, localizer, readings.size() / 2);
  EXPECT_LT(drive.worst_m, 0.06);
  EXPECT_LT(drive.worst_deg, 1.0);
}

/// How far off the robot ends that drives around half the room and then backs up ten steps, which
/// odometry reports as driven forwards.
double off_after_backing_up_m(const LocalizeOptions& options) {
  const auto readings = every(4, laps(1));
  RoomLocalizer localizer{options};
  localizer.add(readings.front(), readings.front().odom_from_robot);
  Pose2 pose = readings.front().odom_from_robot;
  const std::size_t middle = readings.size() / 2;
  std::size_t here = 0;
  const auto drive_to = [&](std::size_t next, double sign) {
    Pose2 step = inverse(readings[here].odom_from_robot) * readings[next].odom_from_robot;
    step.x_m *= sign;
    pose = localizer.locate(readings[next], pose * step, step);
    here = next;
  };
  while (here < middle) drive_to(here + 1, 1.0);
  while (here > middle - 10) drive_to(here - 1, -1.0);
  return (pose.position() - readings[here].odom_from_robot.position()).norm();
}

TEST(RoomLocalizer, FindsTheRobotThatBackedUpUnreported) {
  LocalizeOptions options;
  EXPECT_LT(off_after_backing_up_m(options), 0.03);
  options.lost_share = 0.0;  // never searches farther
  EXPECT_GT(off_after_backing_up_m(options), 0.3);
}

TEST(RoomLocalizer, GivesTheSameBitsTwice) {
  const auto readings = every(3, laps(1));
  RoomLocalizer one{LocalizeOptions{}};
  RoomLocalizer other{LocalizeOptions{}};
  for (const RangeReading& reading : readings) {
    const Pose2 predicted = reading.odom_from_robot * Pose2{0.02, 0.01, 0.01};
    EXPECT_EQ(one.locate(reading, predicted, {0.05, 0.0, 0.01}),
              other.locate(reading, predicted, {0.05, 0.0, 0.01}));
  }
}

struct CorridorLaser {
  int beams = 323;
  double noise_m = 0.018;
  double step_m = 0.0445;  ///< driven from sweep to sweep
};

std::shared_ptr<RangeSensor> sensor_of(const CorridorLaser& laser) {
  auto sensor = std::make_shared<RangeSensor>();
  sensor->kind = SensorKind::laser;
  sensor->max_range_m = 12.75;
  for (int i = 0; i < laser.beams; ++i) {
    sensor->robot_from_beam.push_back({0.0, 0.0, radians(-120.0 + 240.0 * i / (laser.beams - 1))});
  }
  return sensor;
}

/// A sweep of 240 degrees and 12.75 m from inside a corridor along x without ends, 2 m wide; ten
/// in a second.
/// @param person where one walks, from the robot
RangeReading sweep_in_corridor(double x_m, std::mt19937& engine, int number = 0,
                               const std::optional<Point2>& person = std::nullopt,
                               const CorridorLaser& laser = {}) {
  std::normal_distribution<double> noise(0.0, laser.noise_m);
  RangeReading reading;
  reading.sensor = sensor_of(laser);
  reading.timestamp_s = 0.1 * number;
  reading.odom_from_robot = {x_m, 0.0, 0.0};
  for (const Pose2& beam : reading.sensor->robot_from_beam) {
    const double across = std::abs(std::sin(beam.theta_rad));
    const double wall_m = across > 1e-6 ? 1.0 / across : 1e9;
    const Point2 ray = direction(beam.theta_rad);
    const double range_m =
        person ? std::min(wall_m, to_disc_m(Point2::Zero(), ray, *person)) : wall_m;
    const bool is_seen = range_m < reading.sensor->max_range_m;
    reading.ranges_m.push_back(
        static_cast<float>(is_seen ? range_m + noise(engine) : reading.sensor->max_range_m));
  }
  return reading;
}

/// By which share 7 m along the corridor come out too long or too short, on average.
double wrong_share(const CorridorLaser& laser, const LocalizeOptions& options = {}) {
  const int steps = static_cast<int>(7.0 / laser.step_m);
  const double path_m = steps * laser.step_m;
  double wrong_m = 0.0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    std::mt19937 engine(seed);
    RoomLocalizer localizer{options};
    localizer.add(sweep_in_corridor(0.0, engine, 0, std::nullopt, laser), {});
    Pose2 pose;
    const Pose2 step{laser.step_m, 0.0, 0.0};
    for (int i = 1; i <= steps; ++i) {
      const RangeReading sweep =
          sweep_in_corridor(i * laser.step_m, engine, 0, std::nullopt, laser);
      pose = localizer.locate(sweep, pose * step, step);
    }
    wrong_m += std::abs(path_m - pose.x_m) / 4.0;
  }
  return wrong_m / path_m;
}

TEST(RoomLocalizer, ABareCorridorIsAsLongAsOdometrySays) {
  EXPECT_LT(wrong_share({}), 0.01);  // with pairs of no direction it was 5 %
}

/// Five of its beams span less than their ranges err, on walls a metre away.
TEST(RoomLocalizer, FineBeamsOfAWideViewAreNotHeldInABareCorridor) {
  const CorridorLaser fine{620, 0.026, 0.02};
  EXPECT_LT(wrong_share(fine), 0.01);
  LocalizeOptions by_five;
  by_five.scan.fine_rad = 0.0;
  EXPECT_GT(wrong_share(fine, by_five), 0.02);
}

/// Share of 7 m along the corridor that is not found, behind a person who walks as fast ahead.
double held_back(const LocalizeOptions& options) {
  constexpr double kStep_m = 0.0445;
  constexpr int kSteps = 160;
  const Point2 ahead(1.3, 0.2);
  std::mt19937 engine(1);
  RoomLocalizer localizer{options};
  for (int i = -12; i <= 0; ++i) {
    localizer.add(sweep_in_corridor(i * kStep_m, engine, i, ahead), {i * kStep_m, 0.0, 0.0});
  }
  Pose2 pose;
  const Pose2 step{kStep_m, 0.0, 0.0};
  for (int i = 1; i <= kSteps; ++i) {
    const RangeReading reading = sweep_in_corridor(i * kStep_m, engine, i, ahead);
    pose = localizer.locate(reading, pose * step, step);
  }
  return 1.0 - pose.x_m / (kSteps * kStep_m);
}

TEST(RoomLocalizer, APersonWhoWalksAheadDoesNotHoldTheRobotBack) {
  LocalizeOptions options;
  EXPECT_LT(std::abs(held_back(options)), 0.02);
  options.moving.kept = 0;  // believes that all stands still
  EXPECT_GT(held_back(options), 0.3);
}

TEST(RoomLocalizer, BelievesThePredictionUntilItHasSeenTheRoomAndAfterForgettingIt) {
  const auto readings = laps(1);
  RoomLocalizer localizer{LocalizeOptions{}};
  const Pose2 odd{11.0, -4.0, 0.6};
  EXPECT_EQ(localizer.locate(readings[0], odd, {}), odd);
  EXPECT_NE(localizer.locate(readings[0], odd * Pose2{0.05, 0.05, 0.02}, {}),
            (odd * Pose2{0.05, 0.05, 0.02}));
  localizer.clear();
  EXPECT_EQ(localizer.locate(readings[0], odd, {}), odd);
}

TEST(RoomLocalizer, BelievesThePredictionWhereTheSweepShowsSomethingElse) {
  const auto readings = laps(1);
  RoomLocalizer localizer{LocalizeOptions{}};
  localizer.add(readings[0], readings[0].odom_from_robot);
  const Pose2 far{50.0, 0.0, 0.0};
  EXPECT_EQ(localizer.locate(readings[1], far, {0.05, 0.0, 0.0}), far);
}

TEST(RoomLocalizer, LeavesSonarsAlone) {
  auto readings = laps(1);
  auto ring = std::make_shared<RangeSensor>(*readings[0].sensor);
  ring->kind = SensorKind::sonar;
  RoomLocalizer localizer{LocalizeOptions{}};
  RangeReading sonar = readings[0];
  sonar.sensor = ring;
  EXPECT_FALSE(can_be_matched(sonar));
  localizer.add(sonar, sonar.odom_from_robot);
  const Pose2 off = readings[0].odom_from_robot * Pose2{0.06, 0.06, 0.03};
  EXPECT_EQ(localizer.locate(sonar, off, {}), off);
  // a sonar did not enter the map either: the first laser has nothing to be matched with
  EXPECT_EQ(localizer.locate(readings[0], off, {}), off);
  EXPECT_EQ(localizer.locate(sonar, Pose2{}, {}), Pose2{});
}

TEST(IsNewView, NeedsMotionOrATurn) {
  const LocalizeOptions options;
  EXPECT_FALSE(is_new_view({1.0, 1.0, 3.1}, {1.05, 1.05, 3.1}, options));
  EXPECT_TRUE(is_new_view({1.0, 1.0, 3.1}, {1.08, 1.08, 3.1}, options));
  EXPECT_FALSE(is_new_view({1.0, 1.0, 3.1}, {1.0, 1.0, 3.1 + radians(3.9) - 2.0 * kPi}, options));
  EXPECT_TRUE(is_new_view({1.0, 1.0, 3.1}, {1.0, 1.0, 3.1 + radians(4.1) - 2.0 * kPi}, options));
  EXPECT_TRUE(is_new_view({1.0, 1.0, 3.1}, {1.05, 1.05, 3.1}, options, true));
}

}  // namespace
}  // namespace roomatlas
