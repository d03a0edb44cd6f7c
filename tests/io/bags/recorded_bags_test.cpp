// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mission_log.hpp"
#include "support/shared_data.hpp"

#include "roomatlas/io/trajectories/trajectory_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace roomatlas::test {
namespace {

/// The share of beams that are no reading.
double unknown_share(const ReadLog& log) {
  double unknown = 0.0;
  double beams = 0.0;
  for (const RangeReading& reading : log.readings) {
    beams += static_cast<double>(reading.ranges_m.size());
    unknown += static_cast<double>(std::count_if(reading.ranges_m.begin(), reading.ranges_m.end(),
                                                 [](float r) { return std::isnan(r); }));
  }
  return unknown / beams;
}

TEST(RecordedBags, OfASmallRobotAreReadWholeWithItsOdometry) {
  const auto bag = shared_data("bags/zaki0929_mit/2019_jan17_expt08_bagfile.bag");
  if (!bag) return;
  const ReadLog log = read_log(*bag);
  EXPECT_EQ(log.readings.size(), 859U);
  EXPECT_EQ(log.info.odometry, "/odom");
  EXPECT_EQ(log.info.sensors.size(), 1U);
  EXPECT_EQ(log.readings[0].sensor->robot_from_beam.size(), 726U);
  EXPECT_NEAR(log.info.path_length_m, 14.2, 0.1);
  EXPECT_EQ(log.info.malformed_lines, 0);
}

TEST(RecordedBags, InvalidBeamsAreNoFreeSpace) {
  const auto bag = shared_data("bags/zaki0929_mit/2019_jan17_expt04_bagfile.bag");
  if (!bag) return;
  EXPECT_NEAR(unknown_share(read_log(*bag)), 0.26, 0.04);
}

TEST(RecordedBags, OdometryInTfAloneIsFound) {
  const auto bag = shared_data("bags/filipkro_hrp/mylaserdata2.bag");
  if (!bag) return;
  const ReadLog log = read_log(*bag);
  EXPECT_EQ(log.info.odometry, "tf odom -> base_link");
  EXPECT_EQ(log.readings.size(), 232U);
  EXPECT_GT(log.info.path_length_m, 5.0);
}

/// No transform tells where the laser sits; three drives of one robot find the same place each.
TEST(RecordedBags, TheMountOfALaserIsFoundAlikeInThreeDrives) {
  for (const char* name : {"mylaserdata2", "mylaserdata3", "mylaserdata4_old"}) {
    const auto bag = shared_data("bags/filipkro_hrp/" + std::string(name) + ".bag");
    if (!bag) return;
    const ReadLog log = read_log(*bag);
    ASSERT_FALSE(log.readings.empty()) << name;
    const Pose2 first = log.readings[0].sensor->robot_from_beam.front();
    EXPECT_LT(first.position().norm(), 0.04) << name;
    // the scan's first beam is at -180 degrees, and the laser looks back
    EXPECT_LT(std::abs(first.theta_rad), radians(4.0)) << name << " " << degrees(first.theta_rad);
  }
}

TEST(RecordedBags, WithoutOdometryAreMissionsAtTheOrigin) {
  const auto bag = shared_data("bags/scan_only/hallway2.bag");
  if (!bag) return;
  const ReadLog log = read_log(*bag);
  EXPECT_EQ(log.readings.size(), 480U);
  EXPECT_EQ(log.info.odometry, "none");
}

TEST(RecordedBags, PosesInTfsRootFrameAreATrajectoryToCompareWith) {
  const auto bag = shared_data("bags/zaki0929_mit/2018_feb13_col.bag");
  if (!bag) return;
  const TrajectoryFile truth = read_trajectory(*bag, {}, LogPoses::truth);
  EXPECT_NE(truth.format.find("tf map -> base_link"), std::string::npos);
  EXPECT_GT(truth.poses.size(), 900U);
  const TrajectoryFile odometry = read_trajectory(*bag, {}, LogPoses::recorded);
  EXPECT_EQ(odometry.poses.size(), 920U);
}

}  // namespace
}  // namespace roomatlas::test
