// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bags/memory_bag.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace roomatlas::test {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A robot that drives 1 m/s along x, odometry at 20 Hz, a scan a tenth of a second, its laser
/// mounted by tf_static.
MemoryBag drive(Layout layout, const TransformFields& mount, const ScanFields& scan,
                double seconds = 3.0) {
  MemoryBag bag(layout);
  bag.tf(100.0, {mount}, "/tf_static");
  for (int i = 0; i <= seconds * 20; ++i) {
    const double time_s = 100.0 + i / 20.0;
    bag.odometry(time_s, {i / 20.0, 0.0, 0.0});
  }
  for (int i = 0; i < seconds * 10; ++i) bag.scan(100.025 + i / 10.0, scan);
  return bag;
}

const TransformFields kAhead{"base_link", "laser", {0.1, 0.0, 0.0}};

TEST(BagSource, OdometryIsInterpolatedToTheScansInEachLayout) {
  for (const Layout layout : {Layout::ros1, Layout::cdr_little, Layout::cdr_big}) {
    const ReadLog log = read_bag(drive(layout, kAhead, {}));
    ASSERT_EQ(log.readings.size(), 30U);
    EXPECT_EQ(log.info.odometry, "/odom");
    EXPECT_EQ(log.info.readings, 30);
    EXPECT_NEAR(log.readings[7].timestamp_s, 100.725, 1e-9);
    EXPECT_NEAR(log.readings[7].odom_from_robot.x_m, 0.725, 1e-9);
    EXPECT_NEAR(log.readings[7].sensor->robot_from_beam[0].x_m, 0.1, 1e-12);
    EXPECT_NEAR(log.readings[7].sensor->robot_from_beam[0].theta_rad, -1.0, 1e-7);
    EXPECT_EQ(log.readings[7].ranges_m, (std::vector<float>{1.0F, 2.0F, 3.0F, 4.0F, 5.0F}));
    EXPECT_EQ(log.readings[0].sensor, log.readings[29].sensor);
    EXPECT_NEAR(log.info.path_length_m, 2.9, 1e-9);
  }
}

TEST(BagSource, RangesMeanWhatREP117AndDriversSay) {
  ScanFields scan;
  scan.angle_increment = 0.2F;
  scan.ranges = {kInf, kNan, -kInf, 0.05F, 0.0F, 10.0F, 65.533F, 9.0F};
  const ReadLog log = read_bag(drive(Layout::ros1, kAhead, scan));
  const RangeReading& reading = log.readings.front();
  const auto max = static_cast<float>(reading.sensor->max_range_m);
  EXPECT_EQ(max, 10.0F);
  EXPECT_EQ(reading.ranges_m[0], max);  // nothing within range: free
  EXPECT_EQ(reading.ranges_m[5], max);
  EXPECT_EQ(reading.ranges_m[7], 9.0F);
  for (const std::size_t none : {1U, 2U, 3U, 4U, 6U}) {
    EXPECT_TRUE(std::isnan(reading.ranges_m[none])) << none;
  }
  EXPECT_TRUE(is_told(log, "of the beams are no reading"));
}

TEST(BagSource, ALaserTurnedUpsideDownOrCountingBackwardsIsSeenFromAbove) {
  const auto bearings = [](const TransformFields& mount, const ScanFields& scan) {
    const ReadLog log = read_bag(drive(Layout::ros1, mount, scan));
    std::vector<std::pair<double, float>> seen;
    for (std::size_t i = 0; i < log.readings[0].ranges_m.size(); ++i) {
      seen.emplace_back(log.readings[0].sensor->robot_from_beam[i].theta_rad,
                        log.readings[0].ranges_m[i]);
    }
    return seen;
  };
  const auto expect = [](const std::vector<std::pair<double, float>>& seen, double first_rad,
                         float first_m, double last_rad, float last_m) {
    EXPECT_NEAR(seen.front().first, first_rad, 1e-6);
    EXPECT_EQ(seen.front().second, first_m);
    EXPECT_NEAR(seen.back().first, last_rad, 1e-6);
    EXPECT_EQ(seen.back().second, last_m);
  };
  TransformFields turned = kAhead;
  turned.pose.theta_rad = kPi / 2.0;
  expect(bearings(turned, {}), kPi / 2.0 - 1.0, 1.0F, kPi / 2.0 + 1.0, 5.0F);
  TransformFields hanging = kAhead;
  hanging.roll_rad = kPi;  // its left is the robot's right
  expect(bearings(hanging, {}), -1.0, 5.0F, 1.0, 1.0F);
  ScanFields backwards;
  backwards.angle_min = 1.0F;
  backwards.angle_increment = -0.5F;
  expect(bearings(kAhead, backwards), -1.0, 5.0F, 1.0, 1.0F);
}

TEST(BagSource, OdometryOfTfAloneIsFoundAndAMapsFrameIsNoOdometry) {
  MemoryBag bag;
  bag.tf(100.0, {kAhead}, "/tf_static");
  for (int i = 0; i <= 60; ++i) {
    const double time_s = 100.0 + i / 20.0;
    bag.tf(time_s, {{"odom", "base_link", {i / 20.0, 0.0, 0.0}}});
    bag.tf(time_s, {{"map", "odom", {50.0 + (i % 7), 0.0, 0.0}}});  // a localizer that jumps
  }
  for (int i = 0; i < 28; ++i) bag.scan(100.025 + i / 10.0, {});
  const ReadLog log = read_bag(bag);
  ASSERT_EQ(log.readings.size(), 28U);
  EXPECT_EQ(log.info.odometry, "tf odom -> base_link");
  EXPECT_NEAR(log.readings[7].odom_from_robot.x_m, 0.725, 1e-9);
  EXPECT_TRUE(log.true_poses.empty());

  MissionOptions with_truth;
  with_truth.recording.truth_topic = "tf";
  const ReadLog judged = read_bag(bag, with_truth);
  EXPECT_EQ(judged.true_poses.size(), 28U);
  EXPECT_GT(judged.true_poses[3].world_from_robot.x_m, 50.0);
}

TEST(BagSource, OdometryThatMovesIsPreferredToOneThatStands) {
  MemoryBag bag = drive(Layout::ros1, kAhead, {});
  for (int i = 0; i <= 300; ++i) bag.odometry(100.0 + i / 100.0, {}, "/a_dead_encoder");
  EXPECT_EQ(read_bag(bag).info.odometry, "/odom");
  MissionOptions options;
  options.recording.odometry_topic = "a_dead_encoder";
  EXPECT_EQ(read_bag(bag, options).info.odometry, "/a_dead_encoder");
}

TEST(BagSource, AMountThatNothingTellsIsAnErrorThatNamesTheOption) {
  MemoryBag bag = drive(Layout::ros1, {"mast", "camera", {}}, {});
  try {
    (void)read_bag(bag);
    FAIL() << "no mount is known";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--laser-mount"), std::string::npos);
  }
  MissionOptions options;
  options.recording.laser_mount = "0.2,-0.1,90";
  const ReadLog log = read_bag(bag, options);
  EXPECT_NEAR(log.readings[0].sensor->robot_from_beam[0].theta_rad, kPi / 2.0 - 1.0, 1e-6);
  EXPECT_NEAR(log.readings[0].sensor->robot_from_beam[0].y_m, -0.1, 1e-12);
  options.recording.laser_mount = "0.2,-0.1";
  EXPECT_THROW((void)read_bag(bag, options), UsageError);
}

TEST(BagSource, ARecordingWithoutRangesSaysWhatComesNearest) {
  MemoryBag bag;
  bag.odometry(1.0, {}).add("/depth", "sensor_msgs/DepthThing", 1.0, {});
  try {
    (void)read_bag(bag);
    FAIL() << "there are no ranges";
  } catch (const NotEnoughError& error) {
    EXPECT_NE(std::string(error.what()).find("sensor_msgs/LaserScan"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("/depth"), std::string::npos);
  }
  MissionOptions options;
  options.recording.scan_topics = "/nowhere";
  EXPECT_THROW((void)read_bag(bag, options), UsageError);
}

TEST(BagSource, StampsOfZeroAndClocksThatDisagreeGoByTheTimesOfRecording) {
  MemoryBag zero;
  MemoryBag apart;
  for (MemoryBag* bag : {&zero, &apart}) {
    bag->tf(100.0, {kAhead}, "/tf_static");
    for (int i = 0; i <= 60; ++i) bag->odometry(100.0 + i / 20.0, {i / 20.0, 0.0, 0.0});
    for (int i = 0; i < 28; ++i) {
      ScanFields scan;
      scan.stamp_s = bag == &zero ? 1e-12 : 5000.0 + i / 10.0;
      bag->scan(100.025 + i / 10.0, scan);
    }
    const ReadLog log = read_bag(*bag);
    ASSERT_EQ(log.readings.size(), 28U);
    EXPECT_NEAR(log.readings[7].odom_from_robot.x_m, 0.725, 1e-9);
    EXPECT_TRUE(is_told(log, "times of recording"));
  }
}

TEST(BagSource, ReadingsBeyondOdometryAreLeftOutAndCounted) {
  MemoryBag bag = drive(Layout::ros1, kAhead, {});
  for (int i = 0; i < 20; ++i) bag.scan(104.0 + i / 10.0, {});
  const ReadLog log = read_bag(bag);
  EXPECT_EQ(log.readings.size(), 30U);
  EXPECT_TRUE(is_told(log, "20 readings are left out"));
}

TEST(BagSource, AMessageThatIsCutIsLeftOutAndCounted) {
  MemoryBag bag = drive(Layout::ros1, kAhead, {});
  bag.messages.back().bytes.resize(40);
  const ReadLog log = read_bag(bag);
  EXPECT_EQ(log.readings.size(), 29U);
  EXPECT_EQ(log.info.malformed_lines, 1);
  EXPECT_TRUE(is_told(log, "/scan: 1 of 30 messages are left out"));
}

TEST(BagSource, WithoutOdometryTheReadingsStandAtTheOrigin) {
  MemoryBag bag;
  for (int i = 0; i < 28; ++i) bag.scan(100.0 + i / 10.0, {});
  const ReadLog log = read_bag(bag);
  EXPECT_EQ(log.readings.size(), 28U);
  EXPECT_EQ(log.info.odometry, "none");
  EXPECT_EQ(log.readings[5].odom_from_robot, Pose2{});
}

TEST(BagSource, TheRecordingIsDescribed) {
  const ReadLog log = read_bag(drive(Layout::ros1, kAhead, {}));
  ASSERT_TRUE(log.info.recording);
  const RecordingInfo& recording = *log.info.recording;
  EXPECT_EQ(recording.base_frame, "base_link");
  EXPECT_EQ(recording.odometry_frame, "odom");
  ASSERT_EQ(recording.topics.size(), 3U);
  EXPECT_EQ(recording.topics[1].name, "/scan");
  EXPECT_EQ(recording.topics[1].use, "laser");
  EXPECT_EQ(recording.topics[1].messages, 30);
  EXPECT_NEAR(recording.topics[1].rate_hz, 10.0, 0.5);
  EXPECT_EQ(recording.topics[1].frames, std::vector<std::string>{"laser"});
  ASSERT_EQ(recording.frames.size(), 1U);
  EXPECT_EQ(recording.frames[0].child, "laser");
  EXPECT_TRUE(recording.frames[0].is_fixed);
  EXPECT_NE(recording.choice.find("/scan, odometry of /odom"), std::string::npos);
}

TEST(BagSource, SingleSonarsAreOneRing) {
  MemoryBag bag;
  bag.tf(100.0,
         {{"base_link", "left", {0.1, 0.1, kPi / 2.0}}, {"base_link", "right", {0.1, -0.1, -1.0}}},
         "/tf_static");
  for (int i = 0; i <= 60; ++i) bag.odometry(100.0 + i / 20.0, {i / 20.0, 0.0, 0.0});
  for (int i = 0; i < 28; ++i) {
    for (const char* side : {"left", "right"}) {
      const double time_s = 100.025 + i / 10.0 + (side[0] == 'l' ? 0.0 : 0.05);
      MessageBytes out(Layout::ros1);
      out.header(time_s, side).add(std::uint8_t{0}).add(0.5F).add(0.1F).add(4.0F);
      out.add(side[0] == 'l' ? 1.5F : kInf);
      bag.add("/sonar", "sensor_msgs/Range", time_s, out.bytes);
    }
  }
  const ReadLog log = read_bag(bag);
  ASSERT_EQ(log.readings.size(), 28U);
  const RangeReading& reading = log.readings[7];
  EXPECT_EQ(reading.sensor->kind, SensorKind::sonar);
  EXPECT_NEAR(reading.sensor->half_cone_rad, 0.25, 1e-6);
  ASSERT_EQ(reading.ranges_m.size(), 2U);
  EXPECT_EQ(reading.ranges_m[0], 1.5F);
  EXPECT_EQ(reading.ranges_m[1], static_cast<float>(reading.sensor->max_range_m));
  EXPECT_NEAR(reading.sensor->robot_from_beam[1].theta_rad, -1.0, 1e-12);
  EXPECT_NEAR(reading.odom_from_robot.x_m, 0.775, 1e-9);
}

}  // namespace
}  // namespace roomatlas::test
