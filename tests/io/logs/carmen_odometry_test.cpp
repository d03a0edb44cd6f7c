// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mission_log.hpp"

#include <gmock/gmock.h>

namespace roomatlas {
namespace {

using test::read_text;
using test::ReadLog;
using test::texts;
using ::testing::Contains;
using ::testing::HasSubstr;

std::string odom(double x_m, double timestamp_s) {
  return "ODOM " + std::to_string(x_m) + " 0 0 0 0 0 " + std::to_string(timestamp_s) + " h 0\n";
}

std::string sonar(double timestamp_s) {
  return "SONAR 0.3 1 2 0 0 0 " + std::to_string(timestamp_s) + " h 0\n";
}

std::vector<double> xs(const ReadLog& log) {
  std::vector<double> values;
  for (const RangeReading& reading : log.readings) values.push_back(reading.odom_from_robot.x_m);
  return values;
}

testing::Matcher<std::vector<double>> are(const std::vector<double>& values) {
  return testing::Pointwise(testing::DoubleNear(1e-9), values);
}

TEST(SonarPose, LiesBetweenTheOdometryLinesAroundItInPositionAndAlongTheShorterArc) {
  const ReadLog log = read_text(
      "ODOM 1 2 3.0 0 0 0 10 h 0\n"
      "SONAR 0.3 1 2 0 0 0 10.25 h 0\n"
      "ODOM 3 6 -3.0 0 0 0 11 h 0\n");
  ASSERT_EQ(log.readings.size(), 1U);
  EXPECT_NEAR(log.readings[0].odom_from_robot.x_m, 1.5, 1e-12);
  EXPECT_NEAR(log.readings[0].odom_from_robot.y_m, 3.0, 1e-12);
  EXPECT_NEAR(log.readings[0].odom_from_robot.theta_rad, 3.0 + 0.25 * (2 * kPi - 6.0), 1e-12);
}

TEST(SonarPose, IsTheOdometryPoseItselfAtTheSameTime) {
  EXPECT_THAT(xs(read_text(odom(1, 10) + sonar(10) + odom(2, 11) + sonar(11))), are({1, 2}));
}

TEST(SonarPose, IsFoundWhenTheSonarLineComesLate) {
  EXPECT_THAT(xs(read_text(odom(0, 10) + odom(1, 11) + odom(2, 12) + sonar(10.5))), are({0.5}));
}

TEST(SonarPose, IsFoundWhenTheSonarLineComesEarly) {
  EXPECT_THAT(xs(read_text(odom(0, 10) + sonar(12.5) + odom(1, 11) + odom(2, 12) + odom(3, 13))),
              are({2.5}));
}

TEST(SonarPose, IsTheNearestOneBeforeTheFirstAndAfterTheLastOdometryLine) {
  EXPECT_THAT(xs(read_text(sonar(9) + odom(1, 10) + odom(2, 11) + sonar(12) + sonar(13))),
              are({1, 2, 2}));
}

TEST(SonarPose, UsesTheNeighboursInTheFileWhenTimeStepsBack) {
  // Between the two lines at 11 s the clock went back by half a second.
  EXPECT_THAT(xs(read_text(odom(0, 10) + odom(1, 11) + odom(2, 10.5) + sonar(10.6) + odom(3, 11))),
              are({2.2}));
  // The sonar belongs to the time before the step, and the robot did not wait for it.
  EXPECT_THAT(xs(read_text(odom(0, 10) + odom(1, 11) + sonar(11.05) + odom(2, 10.5) + odom(3, 11) +
                           odom(4, 11.5))),
              are({1}));
}

TEST(SonarPose, IsThatOfANeighbourInTheFileWhenTheClocksDisagree) {
  std::string text = odom(0, 10) + sonar(500.0);
  for (int i = 1; i < 100; ++i) text += odom(i, 10 + i);
  EXPECT_THAT(xs(read_text(text)), are({1}));
}

TEST(SonarPose, ComesFromThePosesOfScansInALogWithoutOdometryLines) {
  const ReadLog log = read_text("FLASER 1 9 1 0 0 1 0 0 10 h 0\n" + sonar(10.5) +
                                "FLASER 1 9 2 0 0 2 0 0 11 h 0\n");
  EXPECT_THAT(xs(log), are({1, 1.5, 2}));
  EXPECT_EQ(log.info.odometry, "poses in scans");
}

TEST(SonarPose, WithoutAnyOdometryIsTheOriginAndTheLogSaysNone) {
  const ReadLog log = read_text(sonar(1) + sonar(2));
  EXPECT_THAT(xs(log), are({0, 0}));
  EXPECT_EQ(log.info.odometry, "none");
  EXPECT_EQ(log.info.readings, 2);
  EXPECT_THAT(texts(log.info.issues), Contains(HasSubstr("no odometry before or near a reading")));
}

TEST(SonarPose, WaitsForAFewHundredEventsAtMost) {
  const test::TemporaryFolder folder;
  std::string text = odom(7, 1);
  for (int i = 0; i < 5000; ++i) text += sonar(2 + i);
  const auto source = open_mission(folder.write("mission.clf", text), {});
  std::int64_t most_ahead = 0;
  std::int64_t handed_out = 0;
  while (const auto event = source->next()) {
    EXPECT_EQ(std::get<RangeReading>(*event).odom_from_robot.x_m, 7.0);
    ++handed_out;
    most_ahead = std::max(most_ahead, source->info().line_counts.at("SONAR") - handed_out);
  }
  EXPECT_EQ(handed_out, 5000);
  EXPECT_GT(most_ahead, 0);
  EXPECT_LE(most_ahead, 256);
}

TEST(SonarPose, WaitsForAFewOdometryLinesAtMost) {
  const test::TemporaryFolder folder;
  std::string text = odom(0, 1) + sonar(1e6);
  for (int i = 1; i < 5000; ++i) text += odom(i, 1 + i);
  const auto source = open_mission(folder.write("mission.clf", text), {});
  ASSERT_TRUE(source->next());
  EXPECT_LE(source->info().line_counts.at("ODOM"), 17);
}

TEST(ScanPose, OfTheLineHoldsEvenWhereOdometryLinesDisagree) {
  const ReadLog log = read_text(odom(5, 1) + "FLASER 1 9 1 0 0 1 0 0 1 h 0\n" + odom(6, 2));
  EXPECT_THAT(xs(log), are({1}));
  EXPECT_EQ(log.info.odometry, "poses in scans");
}

TEST(ScanPose, ThatIsAllZeroIsAnEmptySlotWhileNoOtherScanHasAPose) {
  const std::string empty = "FLASER 1 9 0 0 0 0 0 0 ";
  const ReadLog log = read_text(odom(5, 1) + empty + "1.5 h 0\n" + odom(6, 2) + empty + "2 h 0\n");
  EXPECT_THAT(xs(log), are({5.5, 6}));
  EXPECT_EQ(log.info.odometry, "ODOM lines");
  EXPECT_NEAR(log.info.path_length_m, 1.0, 1e-12);
}

TEST(ScanPose, ThatIsAllZeroHoldsInALogWhoseScansHavePoses) {
  const std::string zero = "FLASER 1 9 0 0 0 0 0 0 ";
  const ReadLog log = read_text(zero + "1 h 0\n" + zero + "2 h 0\nFLASER 1 9 1 0 0 1 0 0 3 h 0\n" +
                                odom(50, 3) + zero + "4 h 0\n");
  EXPECT_THAT(xs(log), are({0, 0, 1, 0}));
}

TEST(ScanPose, ThatIsAllZeroInALogWithoutOdometryMeansNoOdometry) {
  const ReadLog log = read_text("FLASER 1 9 0 0 0 0 0 0 1 h 0\n");
  EXPECT_EQ(log.readings.size(), 1U);
  EXPECT_EQ(log.info.odometry, "none");
}

TEST(EventOrder, IsTheOrderOfTheFileAlsoWhereReadingsWait) {
  const test::TemporaryFolder folder;
  const auto source = open_mission(
      folder.write("mission.clf", odom(0, 1) + sonar(1.5) + "TRUEPOS 1 0 0 0 0 0 1.2 h 0\n" +
                                      "FLASER 1 9 3 0 0 3 0 0 1.1 h 0\n" + odom(1, 2)),
      {});
  EXPECT_EQ(std::get<RangeReading>(source->next().value()).timestamp_s, 1.5);
  EXPECT_EQ(std::get<TruePose>(source->next().value()).timestamp_s, 1.2);
  EXPECT_EQ(std::get<RangeReading>(source->next().value()).timestamp_s, 1.1);
  EXPECT_FALSE(source->next());
  EXPECT_FALSE(source->next());
}

TEST(MissionInfo, TellsALogWithoutRanges) {
  const ReadLog log = read_text(odom(0, 1) + odom(3, 2));
  EXPECT_EQ(log.info.readings, 0);
  EXPECT_EQ(log.info.odometry, "ODOM lines");
  EXPECT_NEAR(log.info.path_length_m, 3.0, 1e-12);
}

}  // namespace
}  // namespace roomatlas
