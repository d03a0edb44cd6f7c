// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mission_log.hpp"

#include <gmock/gmock.h>

namespace roomatlas {
namespace {

using test::read_text;
using test::ReadLog;
using test::times;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

void expect_pose(const Pose2& actual, const Pose2& expected) {
  EXPECT_NEAR(actual.x_m, expected.x_m, 1e-9);
  EXPECT_NEAR(actual.y_m, expected.y_m, 1e-9);
  EXPECT_NEAR(wrap_angle(actual.theta_rad - expected.theta_rad), 0.0, 1e-9);
}

double beam_deg(const RangeReading& reading, std::size_t beam) {
  return degrees(reading.sensor->robot_from_beam.at(beam).theta_rad);
}

TEST(CarmenLayout, AFrontLaserLineGivesItsRangesTheRobotPoseAndTheTimestampOfThirdLastField) {
  const ReadLog log =
      read_text("FLASER 3 1.5 2.25 81.91 1.2 2 0 1 2 0 1211.520329 magnum 0.015885\n");
  ASSERT_EQ(log.readings.size(), 1U);
  const RangeReading& reading = log.readings[0];
  EXPECT_EQ(reading.timestamp_s, 1211.520329);
  EXPECT_EQ(reading.odom_from_robot, (Pose2{1, 2, 0}));
  EXPECT_THAT(reading.ranges_m, ElementsAre(1.5F, 2.25F, 81.91F));
  EXPECT_EQ(reading.sensor->kind, SensorKind::laser);
  EXPECT_EQ(reading.sensor->max_range_m, 50.0);
  for (const Pose2& beam : reading.sensor->robot_from_beam) {
    EXPECT_NEAR(beam.x_m, 0.2, 1e-9);
    EXPECT_NEAR(beam.y_m, 0.0, 1e-9);
  }
  EXPECT_EQ(log.info.format, "CARMEN");
  EXPECT_EQ(log.info.file, "mission.clf");
  EXPECT_EQ(log.info.odometry, "poses in scans");
  EXPECT_TRUE(log.info.has_times);
}

TEST(CarmenLayout, AFrontLasersDirectionsFollowFromTheNumberOfReadings) {
  struct Case {
    int count;
    double step_deg;
    double last_deg;
  };
  for (const Case c :
       {Case{180, 1.0, 89.0}, Case{181, 1.0, 90.0}, Case{360, 0.5, 89.5}, Case{361, 0.5, 90.0}}) {
    const ReadLog log = read_text("FLASER " + std::to_string(c.count) + times(c.count, "1") +
                                  " 0 0 0 1 1 1 9 h 0\n");
    ASSERT_EQ(log.readings.size(), 1U);
    const double mounting_deg = degrees(-1.0);  // the laser looks along x, the robot does not
    EXPECT_NEAR(beam_deg(log.readings[0], 0) - mounting_deg, -90.0, 0.006) << c.count;
    EXPECT_NEAR(beam_deg(log.readings[0], 1) - beam_deg(log.readings[0], 0), c.step_deg, 1e-9);
    EXPECT_NEAR(beam_deg(log.readings[0], static_cast<std::size_t>(c.count) - 1) - mounting_deg,
                c.last_deg, 0.006);
    EXPECT_THAT(log.info.issues, IsEmpty());
  }
}

TEST(CarmenLayout, AnUnusualNumberOfReadingsSpreadsOver180DegreesAndIsWarnedOfOnce) {
  const ReadLog log = read_text(
      "FLASER 5 1 1 1 1 1 0 0 0 1 0 0 9 h 0\n"
      "FLASER 5 1 1 1 1 1 0 0 0 1 0 0 9 h 0\n");
  ASSERT_EQ(log.readings.size(), 2U);
  EXPECT_NEAR(beam_deg(log.readings[0], 0), -90.0, 1e-9);
  EXPECT_NEAR(beam_deg(log.readings[0], 1), -45.0, 1e-9);
  EXPECT_NEAR(beam_deg(log.readings[0], 4), 90.0, 1e-9);
  ASSERT_EQ(log.info.issues.size(), 1U);
  EXPECT_EQ(log.info.issues[0].severity, Severity::warning);
  EXPECT_THAT(to_string(log.info.issues[0]),
              HasSubstr("mission.clf:1: FLASER number of readings: 5 readings instead of 180"));
}

TEST(CarmenLayout, ARearLaserLooksBackwardsUnlessItsPosesTellOtherwise) {
  const ReadLog same = read_text("RLASER 1 1 4 5 1 4 5 1 9 h 0\n");
  expect_pose(same.readings.at(0).sensor->robot_from_beam.at(0), {0, 0, kPi});
  const ReadLog offset = read_text(
      "PARAM robot_rearlaser_offset -0.23 0 h 0\n"
      "RLASER 1 1 4 5 1 4 5 1 9 h 0\n");
  expect_pose(offset.readings.at(0).sensor->robot_from_beam.at(0), {-0.23, 0, kPi});
  const ReadLog told = read_text("RLASER 1 1 3.7 5 2.8 4 5 0 9 h 0\n");
  expect_pose(told.readings.at(0).sensor->robot_from_beam.at(0), {-0.3, 0, 2.8});
}

TEST(CarmenLayout, ARobotLaserLineTellsItsDirectionsAndItsMaximumRange) {
  const ReadLog log = read_text(
      "ROBOTLASER1 4 -0.5 1.0 0.25 20 0.01 0 3 1 2 3 2 7 8 "
      "1.1 2 0.5 1 2 0.4 0.3 0.02 0.1 0.1 1e6 77.5 host 0.1\n"
      "ROBOTLASER1 4 -0.5 1.0 0 81 0.01 0 5 1 2 3 4 5 0 "
      "1.1 2 0.5 1 2 0.4 0.3 0.02 0.1 0.1 1e6 78.5 host 0.2\n");
  ASSERT_EQ(log.readings.size(), 2U);
  const RangeReading& first = log.readings[0];
  EXPECT_THAT(first.ranges_m, ElementsAre(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(first.timestamp_s, 77.5);
  expect_pose(first.odom_from_robot, {1, 2, 0.4});
  EXPECT_EQ(first.sensor->max_range_m, 20.0);
  EXPECT_NEAR(first.sensor->robot_from_beam[0].theta_rad, 0.1 - 0.5, 1e-9);
  EXPECT_NEAR(first.sensor->robot_from_beam[2].theta_rad, 0.1, 1e-9);
  EXPECT_NEAR(first.sensor->robot_from_beam[0].x_m, 0.1 * std::cos(0.4), 6e-4);
  EXPECT_NEAR(first.sensor->robot_from_beam[0].y_m, -0.1 * std::sin(0.4), 6e-4);
  const RangeReading& second = log.readings[1];  // no step: the field of view, five beams
  EXPECT_EQ(second.sensor->robot_from_beam.size(), 5U);
  EXPECT_NEAR(second.sensor->robot_from_beam[4].theta_rad, 0.1 + 0.5, 1e-9);
  EXPECT_EQ(second.sensor->max_range_m, 50.0);
  EXPECT_EQ(log.info.sensors.size(), 2U);
}

TEST(CarmenLayout, ARawLaserLineTakesItsMountingFromParametersAndItsPoseFromOdometry) {
  const ReadLog log = read_text(
      "PARAM robot_frontlaser_offset 0.15 0 h 0\n"
      "ODOM 1 2 0 0 0 0 10 h 0\n"
      "RAWLASER1 0 -0.1 0.2 0.1 8 0.01 0 3 1 2 3 0 10 h 0\n"
      "RAWLASER2 0 -0.1 0.2 0.1 8 0.01 0 3 1 2 3 0 10 h 0\n"
      "RAWLASER3 0 -0.1 0.2 0.1 8 0.01 0 3 1 2 3 0 10 h 0\n");
  ASSERT_EQ(log.readings.size(), 3U);
  EXPECT_EQ(log.readings[0].odom_from_robot, (Pose2{1, 2, 0}));
  expect_pose(log.readings[0].sensor->robot_from_beam[0], {0.15, 0, -0.1});
  expect_pose(log.readings[1].sensor->robot_from_beam[0], {0, 0, kPi - 0.1});
  expect_pose(log.readings[2].sensor->robot_from_beam[0], {0, 0, -0.1});
  EXPECT_EQ(log.info.odometry, "ODOM lines");
}

TEST(CarmenLayout, ASonarLineTellsEachSonarsMountingAndItsOpeningAngle) {
  const ReadLog log = read_text(
      "PARAM robot_max_sonar 3 0 h 0\n"
      "ODOM 1 2 0.5 0 0 0 10 h 0\n"
      "SONAR 0.5236 2 1.25 3 0.1 0.2 1.571 0.3 -0.2 0 10 h 0\n");
  ASSERT_EQ(log.readings.size(), 1U);
  const RangeReading& reading = log.readings[0];
  EXPECT_THAT(reading.ranges_m, ElementsAre(1.25F, 3.0F));
  EXPECT_EQ(reading.odom_from_robot, (Pose2{1, 2, 0.5}));
  EXPECT_EQ(reading.sensor->kind, SensorKind::sonar);
  EXPECT_EQ(reading.sensor->half_cone_rad, 0.5236 / 2);
  EXPECT_EQ(reading.sensor->max_range_m, 3.0);
  EXPECT_THAT(reading.sensor->robot_from_beam,
              ElementsAre(Pose2{0.1, 0.2, 1.571}, Pose2{0.3, -0.2, 0}));
}

TEST(CarmenLayout, ASonarsOpeningAngleOfPiOrMoreIsReadAsDegreesAndNoted) {
  const ReadLog log = read_text("ODOM 0 0 0 0 0 0 1 h 0\nSONAR 20 1 1 0 0 0 1 h 0\n");
  EXPECT_NEAR(log.readings.at(0).sensor->half_cone_rad, radians(10.0), 1e-12);
  EXPECT_THAT(test::texts(log.info.issues),
              ElementsAre(HasSubstr("mission.clf:2: SONAR cone_angle: expected radians")));
}

TEST(CarmenLayout, ASonarsNegativeOpeningAngleMeansTheOptionAndIsNoted) {
  const ReadLog log = read_text("ODOM 0 0 0 0 0 0 1 h 0\nSONAR -0.5 1 1 0 0 0 1 h 0\n");
  EXPECT_NEAR(log.readings.at(0).sensor->half_cone_rad, radians(15.0), 1e-12);
  EXPECT_THAT(test::texts(log.info.issues),
              ElementsAre("mission.clf:2: SONAR cone_angle: expected radians from 0 to pi, found "
                          "-0.5: --sonar-cone holds instead"));
}

TEST(CarmenLayout, AFrontLasersPosesMayBeMissingWithOrWithoutWhatFollowsThem) {
  for (const char* end : {"", " 1", " 1 h", " 1 h 1"}) {
    const std::string scan = "FLASER 3 1.0 2.0 1.5" + std::string(end) + "\n";
    const bool has_time = std::string(end) != "";
    const ReadLog log = read_text((has_time ? "ODOM 7 0 0 0 0 0 1 h 0\n" : "ODOM 7 0 0\n") + scan);
    ASSERT_EQ(log.readings.size(), 1U) << scan;
    EXPECT_THAT(log.readings[0].ranges_m, ElementsAre(1.0F, 2.0F, 1.5F));
    EXPECT_EQ(log.readings[0].timestamp_s, has_time ? 1.0 : 0.0);
    EXPECT_EQ(log.readings[0].odom_from_robot, (Pose2{7, 0, 0})) << scan;
    EXPECT_EQ(log.info.malformed_lines, 0);
  }
}

TEST(CarmenLayout, ATruePoseComesInFileOrderAndIsTheFirstTriple) {
  const ReadLog log = read_text("TRUEPOS 1 2 3 4 5 6 99.5 h 0\n");
  ASSERT_EQ(log.true_poses.size(), 1U);
  EXPECT_EQ(log.true_poses[0].timestamp_s, 99.5);
  EXPECT_EQ(log.true_poses[0].world_from_robot, (Pose2{1, 2, 3}));
  EXPECT_EQ(log.info.true_poses, 1);
}

TEST(CarmenLayout, ParametersGiveTheFootprintAndTheSmallerMaximumRangeHolds) {
  const std::string scan = "FLASER 1 1 1 0 0 1 0 0 9 h 0\n";
  const ReadLog log = read_text(
      "PARAM robot_length 0.47 1071078718.462472 merci 1071078718.462472\n"
      "PARAM robot_width 0.41 0 h 0\n"
      "PARAM robot_front_laser_max 30 0 h 0\n"
      "PARAM laser_front_laser_dev /dev/ttyS0 0 h 0\n" +
      scan);
  EXPECT_EQ(log.info.footprint.length_m, 0.47);
  EXPECT_EQ(log.info.footprint.width_m, 0.41);
  EXPECT_EQ(log.readings.at(0).sensor->max_range_m, 30.0);
  EXPECT_EQ(log.info.line_counts.at("PARAM"), 4);
  MissionOptions options;
  options.laser_max_range_m = 12.0;
  const ReadLog nearer = read_text("PARAM robot_front_laser_max 30 0 h 0\n" + scan, options);
  EXPECT_EQ(nearer.readings.at(0).sensor->max_range_m, 12.0);
}

TEST(CarmenLayout, ALogWithoutTimesCountsItsReadings) {
  const ReadLog log = read_text(
      "ODOM 0 0 0\n"
      "FLASER 1 5\n"
      "ODOM 1 0 0 0 0 0\n"
      "FLASER 1 6 1 0 0 1 0 0\n"
      "TRUEPOS 1 0 0 1 0 0\n"
      "FLASER 1 7 2 0 0 2 0 0\n");
  ASSERT_EQ(log.readings.size(), 3U);
  EXPECT_FALSE(log.info.has_times);
  EXPECT_EQ(log.readings[0].timestamp_s, 0.0);
  EXPECT_EQ(log.readings[1].timestamp_s, 1.0);
  EXPECT_EQ(log.readings[2].timestamp_s, 2.0);
  EXPECT_EQ(log.readings[0].odom_from_robot, (Pose2{0, 0, 0}));
  EXPECT_EQ(log.readings[2].odom_from_robot, (Pose2{2, 0, 0}));
  EXPECT_EQ(log.true_poses.at(0).timestamp_s, 2.0);
  EXPECT_EQ(log.info.first_timestamp_s, 0.0);
  EXPECT_EQ(log.info.last_timestamp_s, 2.0);
  EXPECT_EQ(log.info.steps_back_in_time, 0);
}

TEST(CarmenLayout, TheLastColumnMayBeAnythingAndTabsOrSeveralBlanksSeparate) {
  const ReadLog log = read_text("FLASER\t1  7   1 2 3  1 2 3  1031745824.658000 b21 1\r\n");
  ASSERT_EQ(log.readings.size(), 1U);
  EXPECT_EQ(log.readings[0].timestamp_s, 1031745824.658);
}

TEST(CarmenLayout, CommentsBlankLinesAndUnknownTagsAreSkippedAndTheTagsCounted) {
  const ReadLog log = read_text(
      "# CARMEN Logfile\n\n   \nSYNC start 1 h 0\n"
      "FLASER 1 7 1 2 3 1 2 3 5 h 0\n# ODOM x y theta\nNEFF 8.4\nNEFF 6\n1 2 3\n");
  EXPECT_EQ(log.readings.size(), 1U);
  EXPECT_THAT(log.info.ignored_line_counts,
              ElementsAre(testing::Pair("(not a tag)", 1), testing::Pair("NEFF", 2),
                          testing::Pair("SYNC", 1)));
  EXPECT_EQ(log.info.malformed_lines, 0);
}

TEST(CarmenLayout, SensorsAreSharedWhileTheirMountingChangesInItsLastDigitsOnly) {
  const ReadLog log = read_text(
      "FLASER 1 7 -0.040000 0 0 0.000000 0 0 1 h 0\n"
      "FLASER 1 7 -0.040001 0 1e-6 0.000001 0 0 2 h 0\n"
      "FLASER 1 7 -0.0404 0 0 0.0002 0 0 3 h 0\n"
      "FLASER 1 7 0.9 0 0 1 0 0 4 h 0\n");
  ASSERT_EQ(log.readings.size(), 4U);
  EXPECT_EQ(log.readings[0].sensor, log.readings[1].sensor);
  EXPECT_EQ(log.readings[0].sensor, log.readings[2].sensor);
  EXPECT_NE(log.readings[0].sensor, log.readings[3].sensor);
  EXPECT_NEAR(log.readings[0].sensor->robot_from_beam[0].x_m, -0.04, 1e-12);
  EXPECT_THAT(log.info.sensors, ElementsAre(log.readings[0].sensor, log.readings[3].sensor));
}

TEST(CarmenLayout, StepsBackInTimeAreCountedPerTagAndTheFileOrderIsKept) {
  const ReadLog log = read_text(
      "ODOM 0 0 0 0 0 0 10.0 h 0\n"
      "FLASER 1 1 1 0 0 1 0 0 9.9 h 0\n"
      "FLASER 1 2 2 0 0 2 0 0 9.1 h 0\n"
      "FLASER 1 3 3 0 0 3 0 0 9.2 h 0\n");
  EXPECT_EQ(log.info.steps_back_in_time, 1);
  EXPECT_EQ(log.readings.at(1).timestamp_s, 9.1);
  EXPECT_EQ(log.readings.at(2).timestamp_s, 9.2);
  EXPECT_EQ(log.info.first_timestamp_s, 10.0);
  EXPECT_EQ(log.info.last_timestamp_s, 9.2);
  EXPECT_NEAR(log.info.path_length_m, 2.0, 1e-12);
}

}  // namespace
}  // namespace roomatlas
