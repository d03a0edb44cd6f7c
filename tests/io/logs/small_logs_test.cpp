// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mission_log.hpp"
#include "support/shared_data.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace roomatlas {
namespace {

using test::read_log;
using test::read_text;
using test::times;
using ::testing::HasSubstr;

TEST(WeanLog, IsReadInMetresWithTheLasersPlaceOnTheRobot) {
  const std::string log =
      "O 100 0 1.5707963267948966 0.1\n"
      "L 100 200 1.5707963267948966 100 225 1.5707963267948966" +
      times(180, "66") +
      " 0.5\n"
      "L 100 300 1.5707963267948966 100 325 1.5707963267948966" +
      times(180, "8183") + " 1.5\n";
  const auto read = read_text(log);
  EXPECT_EQ(read.info.format, "Wean Hall");
  ASSERT_EQ(read.readings.size(), 2U);
  const RangeReading& reading = read.readings[0];
  EXPECT_EQ(reading.timestamp_s, 0.5);
  EXPECT_NEAR(reading.odom_from_robot.y_m, 2.0, 1e-12);
  EXPECT_FLOAT_EQ(reading.ranges_m[7], 0.66F);
  EXPECT_NEAR(reading.sensor->robot_from_beam[0].x_m, 0.25, 1e-12);
  EXPECT_NEAR(reading.sensor->robot_from_beam[0].theta_rad, radians(-90), 1e-12);
  EXPECT_NEAR(read.info.path_length_m, 1.0, 1e-12);
  EXPECT_GE(static_cast<double>(read.readings[1].ranges_m[0]), reading.sensor->max_range_m);
}

TEST(WeanLog, LeavesLinesOutThatAreNotRightAndSaysSo) {
  const auto read = read_text("O 1 2 0 0.1\nL 1 2 0 1 2 0 5 5 5\nO 1 x 0 0.2\nZ 3\n");
  EXPECT_EQ(read.info.malformed_lines, 3);
  EXPECT_THAT(to_string(read.info.issues.at(0)), HasSubstr("no range readings: 1 L lines"));
  EXPECT_THAT(to_string(read.info.issues.at(1)),
              HasSubstr("mission.clf:2: range: expected a finite"));
  EXPECT_THAT(to_string(read.info.issues.at(2)), HasSubstr("mission.clf:3: y: expected a finite"));
}

TEST(DukeLog, HasNoTimesSoThatReadingsAreNumbered) {
  const auto read = read_text("Odometry 1 2 0.5 \nLaser 181" + times(181, "3.5") +
                              " \nOdometry 2 2 0.5\nLaser 181" + times(181, "8.19") + "\n");
  EXPECT_EQ(read.info.format, "DP-SLAM");
  EXPECT_FALSE(read.info.has_times);
  ASSERT_EQ(read.readings.size(), 2U);
  EXPECT_EQ(read.readings[1].timestamp_s, 1.0);
  EXPECT_EQ(read.readings[1].odom_from_robot, (Pose2{2, 2, 0.5}));
  EXPECT_LT(read.readings[1].sensor->max_range_m, 8.19);
  EXPECT_EQ(read.readings[0].sensor->robot_from_beam.size(), 181U);
}

/// A scan line of the layout with 25 fields before the ranges.
std::string mines_line(const std::string& time, int left, int right, const std::string& range) {
  return time + " 7 " + std::to_string(left) + " " + std::to_string(right) + times(21, "0") +
         times(682, range) + "\n";
}

TEST(MinesLog, ReckonsByItsWheelsAndKeepsTheBeamsThatSeeOut) {
  const auto read =
      read_text(mines_line("1000000", 500, 700, "2000") +
                mines_line("2000000", 2500, 2700, "2000") + mines_line("3000000", 2000, 3200, "7"));
  EXPECT_EQ(read.info.format, "tinySLAM");
  ASSERT_EQ(read.readings.size(), 3U);
  const double turn_m = 2.0 * kPi * 0.077;  // of a wheel
  EXPECT_EQ(read.readings[0].odom_from_robot, Pose2{});
  EXPECT_NEAR(read.readings[1].odom_from_robot.x_m, turn_m, 1e-12);
  EXPECT_NEAR(read.readings[2].odom_from_robot.x_m, turn_m, 1e-12);  // on the spot
  EXPECT_NEAR(read.readings[2].odom_from_robot.theta_rad, 0.25 * turn_m / 0.165, 1e-12);
  EXPECT_EQ(read.readings[1].timestamp_s, 2.0);
  EXPECT_TRUE(std::isnan(read.readings[0].ranges_m[69]));
  EXPECT_FLOAT_EQ(read.readings[0].ranges_m[70], 2.0F);
  EXPECT_TRUE(std::isnan(read.readings[2].ranges_m[300]));  // 7 mm is an error code
}

TEST(MinesLog, OfTheOtherLayoutHasARightWheelThatCountsBackwards) {
  const auto line = [](int left, int right) {
    return "1000000 " + std::to_string(left) + " " + std::to_string(right) + times(10, "0") +
           times(682, "2000") + "\n";
  };
  const auto read = read_text(line(0, 0) + line(2000, -2000));
  EXPECT_NEAR(read.readings.at(1).odom_from_robot.x_m, 2.0 * kPi * 0.077, 1e-12);
  EXPECT_NEAR(read.readings.at(1).odom_from_robot.theta_rad, 0.0, 1e-12);
}

TEST(SmallLogs, AsRecordedHaveTheirKnownLengths) {
  struct Known {
    const char* file;
    std::int64_t readings;
    double path_m;
  };
  for (const Known& known : {Known{"logs/wean/robotdata1.log.gz", 713, 41.0},
                             {"logs/duke-loop5/loop5.log.gz", 551, 56.0},
                             {"logs/mines-rover/exp1.dat.gz", 756, 46.0},
                             {"logs/mines-rover/test_lab.dat.gz", 590, 25.5}}) {
    const auto file = test::shared_data(known.file);
    if (!file) return;
    const auto read = read_log(*file);
    EXPECT_EQ(read.info.readings, known.readings) << known.file;
    EXPECT_NEAR(read.info.path_length_m, known.path_m, 0.5) << known.file;
  }
}

/// The log writes the robot's own heading, in degrees, beside the ticks. (Its lengths are a tenth
/// shorter than the wheels that are published give.)
TEST(MinesLog, TurnsAsTheRobotReckonedItself) {
  const auto file = test::shared_data("logs/mines-rover/test_lab.dat.gz");
  if (!file) return;
  const auto read = read_log(*file);
  const Pose2& last = read.readings.back().odom_from_robot;
  gzFile text = gzopen(file->c_str(), "rb");
  std::vector<char> line(16384);
  std::vector<Pose2> own;
  while (gzgets(text, line.data(), static_cast<int>(line.size())) != nullptr) {
    double field[6];
    if (std::sscanf(line.data(), "%lf %lf %lf %lf %lf %lf", field, field + 1, field + 2, field + 3,
                    field + 4, field + 5) == 6 &&
        own.size() < read.readings.size()) {
      own.push_back({field[3], field[4], wrap_angle(radians(field[5]))});
    }
  }
  gzclose(text);
  const Pose2 theirs = inverse(own.front()) * own.back();
  EXPECT_NEAR(wrap_angle(theirs.theta_rad - last.theta_rad), 0.0, radians(6.0));
}

}  // namespace
}  // namespace roomatlas
