// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mission_log.hpp"

#include <gmock/gmock.h>

namespace roomatlas {
namespace {

using test::read_text;
using test::ReadLog;
using test::texts;
using test::times;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string odom(const std::string& x, int timestamp_s) {
  return "ODOM " + x + " 0 0 0 0 0 " + std::to_string(timestamp_s) + " h 0\n";
}

std::string scan(const std::string& laser_x, const std::string& robot_x, int timestamp_s,
                 const std::string& tag = "FLASER") {
  return tag + " 180" + times(180, "1") + " " + laser_x + " 0 0 " + robot_x + " 0 0 " +
         std::to_string(timestamp_s) + " h 0\n";
}

std::string sonar(const std::string& offset_x, int timestamp_s) {
  return "SONAR 0.3 1 2 " + offset_x + " 0 0 " + std::to_string(timestamp_s) + " h 0\n";
}

std::vector<double> xs(const ReadLog& log) {
  std::vector<double> values;
  for (const RangeReading& reading : log.readings) values.push_back(reading.odom_from_robot.x_m);
  return values;
}

/// The one issue of a log of which one line is left out.
std::string issue_of(const std::string& text) {
  const ReadLog log = read_text(text);
  EXPECT_EQ(log.info.malformed_lines, 1) << text;
  EXPECT_EQ(log.info.issues.size(), 1U) << text;
  return log.info.issues.empty() ? "" : to_string(log.info.issues[0]);
}

TEST(ImplausibleMount, OfALaserFarFromTheRobotIsLeftOutWithItsLine) {
  const std::string good = scan("0.2", "0", 1) + scan("1.2", "1", 2);
  EXPECT_EQ(
      issue_of(good + scan("1000000", "2", 3) + scan("2.2", "2", 4)),
      "mission.clf:3: FLASER laser and robot pose: expected the laser at most 10 m from the "
      "robot's centre, found it 999998 m away; the line is left out: correct it or delete it");
  EXPECT_THAT(issue_of(good + scan("2.2", "1000000", 3) + scan("2.2", "2", 4)),
              HasSubstr("mission.clf:3: FLASER laser and robot pose"));
  EXPECT_THAT(issue_of(scan("1000000", "0", 1) + good), HasSubstr("mission.clf:1:"));
  EXPECT_THAT(issue_of(scan("0", "1000000", 1) + good), HasSubstr("mission.clf:1:"));
}

TEST(ImplausibleMount, OfASonarIsLeftOutWithItsLine) {
  EXPECT_EQ(issue_of(odom("0", 1) + sonar("0.2", 1) + sonar("1e6", 2) + sonar("0.2", 3)),
            "mission.clf:3: SONAR offset x: expected metres, at most 10 m from the robot's centre, "
            "found '1e6'; the line is left out: correct it or delete it");
}

TEST(ImplausibleMount, InAParameterIsLeftOut) {
  EXPECT_THAT(
      issue_of("PARAM robot_frontlaser_offset 250\nODOM 1 2 3\n"),
      HasSubstr("PARAM robot_frontlaser_offset: expected a length in metres from -10 to 10, "
                "found '250', which looks like millimetres or centimetres; the line is"));
}

TEST(ImplausibleSize, OfTheRobotIsLeftOutSoThatTheOptionHolds) {
  for (const char* length : {"450", "45", "5.1", "0.04", "-0.5", "nan", "1e999"}) {
    const ReadLog log =
        read_text("PARAM robot_length " + std::string(length) + "\n" + odom("0", 1));
    EXPECT_EQ(log.info.footprint.length_m, RobotFootprint{}.length_m) << length;
    EXPECT_EQ(log.info.malformed_lines, 1) << length;
  }
  EXPECT_EQ(issue_of("PARAM robot_width 450\n" + odom("0", 1)),
            "mission.clf:1: PARAM robot_width: expected a length in metres from 0.05 to 5, found "
            "'450', which looks like millimetres or centimetres; the line is left out: correct it "
            "or delete it");
}

TEST(ImplausibleRange, InAParameterIsLeftOutSoThatTheOptionHolds) {
  for (const char* max : {"8191", "0.1", "0", "-30"}) {
    const ReadLog log =
        read_text("PARAM robot_front_laser_max " + std::string(max) + "\n" + scan("0", "0", 1));
    EXPECT_EQ(log.readings.at(0).sensor->max_range_m, 50.0) << max;
    EXPECT_EQ(log.info.malformed_lines, 1) << max;
  }
  EXPECT_THAT(issue_of("PARAM robot_max_sonar 5000\n" + odom("0", 1)),
              HasSubstr("from 0.5 to 100, found '5000', which looks like millimetres"));
}

TEST(ImplausibleMount, OfAWeanLogsLaserIsLeftOutWithItsLine) {
  const auto line = [](const std::string& laser_x) {
    return "L 0 0 0 " + laser_x + " 0 0" + times(180, "66") + " 0.5\n";
  };
  EXPECT_THAT(issue_of(line("20") + line("1e8")), HasSubstr("found it 1e+06 m away"));
}

TEST(ImplausiblePosition, BeyondWhatAPlanHoldsIsLeftOutWithItsLine) {
  const std::string sonars = sonar("0", 1) + sonar("0", 3);
  EXPECT_EQ(issue_of(odom("0", 1) + odom("1e7", 2) + odom("0", 3) + sonars),
            "mission.clf:2: ODOM x: expected metres, at most 9990 km from the origin, found '1e7'; "
            "the line is left out: correct it or delete it");
  EXPECT_THAT(issue_of(scan("0", "0", 1) + scan("-1e300", "-1e300", 2) + scan("1", "1", 2)),
              HasSubstr("mission.clf:2: FLASER laser x"));
  EXPECT_THAT(issue_of("TRUEPOS 0 1e9 0 0 0 0 1 h 0\nODOM 0 0 0 0 0 0 1 h 0\n"),
              HasSubstr("mission.clf:1: TRUEPOS true_y"));
  EXPECT_THAT(issue_of("Odometry 1e8 2 0.5\nOdometry 1 2 0.5\n"),
              HasSubstr("mission.clf:1: x, y: expected at most 9990 km from the origin, found"));
}

TEST(ImplausiblePosition, OfAMapGridIsKept) {
  const ReadLog log = read_text(scan("500000", "500000", 1) + scan("9857000", "9857000", 1000000));
  EXPECT_THAT(xs(log), ElementsAre(500000.0, 9857000.0));
  EXPECT_THAT(log.info.issues, IsEmpty());
}

TEST(Spike, OfOdometryIsLeftOutAndReadingsBesideItLieBetweenTheOthers) {
  const ReadLog log =
      read_text(odom("0", 0) + sonar("0", 1) + odom("1e6", 2) + sonar("0", 3) + odom("4", 4));
  EXPECT_THAT(xs(log), ElementsAre(1.0, 3.0));
  EXPECT_EQ(log.info.malformed_lines, 1);
  EXPECT_EQ(log.info.line_counts.at("ODOM"), 2);
  EXPECT_NEAR(log.info.path_length_m, 4.0, 1e-12);
  EXPECT_THAT(texts(log.info.issues),
              ElementsAre("mission.clf:3: ODOM position: jumps 1e+06 m away from the line before "
                          "it and does not stay there: expected what a robot can drive in that "
                          "time; the line is left out: correct it or delete it"));
}

TEST(Spike, OfAScansPoseIsLeftOutAlsoWhereLinesOfAnotherLaserLieBetween) {
  std::string text;
  for (int i = 0; i < 5; ++i) {
    const std::string x = i == 2 ? "300" : std::to_string(i);
    text += scan(x, x, i) + scan("0", "0", i, "RLASER");
  }
  const ReadLog log = read_text(text);
  EXPECT_THAT(xs(log), ElementsAre(0, 0, 1, 0, 0, 3, 0, 4, 0));
  EXPECT_EQ(log.info.malformed_lines, 1);
}

TEST(Spike, InTheLastLineIsLeftOut) {
  const ReadLog log = read_text(scan("0", "0", 0) + scan("1", "1", 1) + scan("1e5", "1e5", 2));
  EXPECT_THAT(xs(log), ElementsAre(0, 1));
  EXPECT_THAT(texts(log.info.issues), ElementsAre(HasSubstr("mission.clf:3: FLASER position")));
}

TEST(Spike, OfADpSlamLogIsLeftOut) {
  std::string text;
  for (const char* x : {"0", "1", "5000", "1.5"}) {
    text += "Odometry " + std::string(x) + " 0 0\nLaser 181" + times(181, "2") + "\n";
  }
  const ReadLog log = read_text(text);
  EXPECT_THAT(xs(log), ElementsAre(0, 1, 1, 1.5));
  EXPECT_THAT(texts(log.info.issues), ElementsAre(HasSubstr("mission.clf:5: the position jumps")));
}

TEST(Jump, ThatStaysIsKept) {
  const std::string before = scan("0", "0", 0) + scan("1", "1", 1);
  const std::string after = scan("500", "500", 2) + scan("501", "501", 3);
  EXPECT_THAT(xs(read_text(before + after)), ElementsAre(0, 1, 500, 501));
}

TEST(Jump, AwayAndBackThatARobotCanDriveIsKept) {
  EXPECT_THAT(xs(read_text(scan("0", "0", 0) + scan("9", "9", 0) + scan("0", "0", 0))),
              ElementsAre(0, 9, 0));
  EXPECT_THAT(xs(read_text(scan("0", "0", 0) + scan("200", "200", 10) + scan("0", "0", 20))),
              ElementsAre(0, 200, 0));
}

TEST(Jump, IsNotWaitedForWithMoreThanAFewDozenLines) {
  const test::TemporaryFolder folder;
  std::string text = odom("0", 0) + odom("1e6", 1);
  for (int i = 0; i < 5000; ++i) text += sonar("0", 1);
  const auto source = open_mission(folder.write("mission.clf", text), {});
  ASSERT_TRUE(source->next());
  EXPECT_LT(source->info().line_counts.at("SONAR"), 300);
  std::int64_t readings = 1;
  while (source->next()) ++readings;
  EXPECT_EQ(readings, 5000);
  EXPECT_EQ(source->info().malformed_lines, 0);
}

}  // namespace
}  // namespace roomatlas
