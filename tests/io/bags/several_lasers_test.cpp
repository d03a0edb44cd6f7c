// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bags/memory_bag.hpp"

#include "roomatlas/io/logs/mission_writer.hpp"

#include "roomatlas/match/scan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace roomatlas::test {
namespace {

constexpr double kRoomM = 5.0;  // from its middle to each wall

/// From a pose inside a square room to its wall.
float range_in_room(const Pose2& world_from_beam) {
  const Point2 ray = direction(world_from_beam.theta_rad);
  double range_m = 1e9;
  for (int axis = 0; axis < 2; ++axis) {
    for (const double wall : {-kRoomM, kRoomM}) {
      const double at_m = (wall - world_from_beam.position()[axis]) / ray[axis];
      if (at_m > 0.0) range_m = std::min(range_m, at_m);
    }
  }
  return static_cast<float>(range_m);
}

/// Drives and turns on an arc.
Pose2 robot_at(double time_s) {
  const double heading_rad = 0.4 * (time_s - 100.0);
  return {std::sin(heading_rad), 1.0 - std::cos(heading_rad), wrap_angle(heading_rad)};
}

struct Laser {
  std::string topic;
  std::string frame;
  Pose2 mount;
  double late_s = 0.0;  ///< of its sweeps, after the full tenths of a second
  double roll_rad = 0.0;
  double view_rad = radians(240.0);
  double z_m = 0.2;
};
const Laser kFront{"/scan", "front_link", {0.3, 0.2, radians(45.0)}};
const Laser kRear{"/rear_scan", "rear_link", {-0.3, -0.2, radians(-135.0)}, 0.03};

MemoryBag recorded_by(const std::vector<Laser>& lasers) {
  MemoryBag bag;
  for (const Laser& laser : lasers) {
    bag.tf(99.0, {{"base_link", laser.frame, laser.mount, laser.roll_rad, laser.z_m}},
           "/tf_static");
  }
  for (int i = -10; i <= 120; ++i) bag.odometry(100.0 + 0.05 * i, robot_at(100.0 + 0.05 * i));
  for (int i = 0; i < 50; ++i) {
    for (const Laser& laser : lasers) {
      ScanFields scan;
      scan.stamp_s = 100.0 + 0.1 * i + laser.late_s;
      scan.frame = laser.frame;
      scan.range_max = 30.0F;
      scan.angle_min = static_cast<float>(-laser.view_rad / 2.0);
      scan.angle_increment = static_cast<float>(radians(1.0));
      const int beams = static_cast<int>(std::lround(degrees(laser.view_rad))) + 1;
      scan.ranges.clear();
      for (int beam = 0; beam < beams; ++beam) {
        const double angle_rad = -laser.view_rad / 2.0 + radians(1.0) * beam;
        const double bearing_rad = laser.roll_rad > 1.0 ? -angle_rad : angle_rad;
        scan.ranges.push_back(
            range_in_room(robot_at(scan.stamp_s) * laser.mount * Pose2{0.0, 0.0, bearing_rad}));
      }
      bag.scan(scan.stamp_s + 0.01, scan, laser.topic);
    }
  }
  return bag;
}

/// How far the ends are from the walls, on average, where odometry puts them; by brute force.
double off_walls_m(const ReadLog& log) {
  double sum_m = 0.0;
  double ends = 0.0;
  for (const RangeReading& reading : log.readings) {
    for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
      if (!(reading.ranges_m[i] > 0.0F)) continue;
      const Point2 end = reading.odom_from_robot *
                         (reading.sensor->robot_from_beam[i] * Point2(reading.ranges_m[i], 0.0));
      sum_m += std::min(std::abs(kRoomM - std::abs(end.x())), std::abs(kRoomM - std::abs(end.y())));
      ends += 1.0;
    }
  }
  return sum_m / ends;
}

TEST(SeveralLasers, OfOneRobotAreOneReadingByThemselves) {
  Laser hanging = kRear;
  hanging.roll_rad = kPi;
  for (const Laser& rear : {kRear, hanging}) {
    const ReadLog log = read_bag(recorded_by({kFront, rear}));
    EXPECT_NE(log.info.recording->choice.find("/scan + /rear_scan as one reading"),
              std::string::npos)
        << log.info.recording->choice;
    ASSERT_EQ(log.readings.size(), 50U);
    ASSERT_EQ(log.info.sensors.size(), 1U);
    EXPECT_EQ(log.info.sensors[0]->robot_from_beam.size(), 482U);
    EXPECT_LT(off_walls_m(log), 0.003);
    for (const RangeReading& reading : log.readings) {
      EXPECT_NEAR(std::remainder(reading.timestamp_s, 0.1), 0.0, 1e-6);  // the first one's
    }
  }
}

TEST(SeveralLasers, ThatAreNoOtherPlaceAreNotJoined) {
  Laser filtered = kFront;
  filtered.topic = "/scan_filtered";
  Laser camera = kRear;
  camera.view_rad = radians(60.0);
  Laser high = kRear;
  high.z_m = 1.2;
  Laser tilted = kRear;
  tilted.roll_rad = radians(20.0);
  for (const Laser& other : {filtered, camera, high, tilted}) {
    const ReadLog log = read_bag(recorded_by({kFront, other}));
    EXPECT_EQ(log.info.recording->choice.find("as one reading"), std::string::npos)
        << log.info.recording->choice;
    EXPECT_TRUE(is_told(log, "not mapped: " + other.topic)) << other.topic;
  }
}

TEST(SeveralLasers, AreJoinedWhereTheOptionNamesThem) {
  Laser high = kRear;
  high.z_m = 1.2;
  MissionOptions options;
  options.recording.scan_topics = "/rear_scan,/scan";
  const ReadLog log = read_bag(recorded_by({kFront, high}), options);
  EXPECT_EQ(log.readings.size(), 50U);
  EXPECT_NEAR(log.readings[3].timestamp_s, 100.33, 1e-6);
  EXPECT_LT(off_walls_m(log), 0.003);
}

TEST(SeveralLasers, OneThatFallsSilentLeavesItsBeamsWithoutRanges) {
  MemoryBag bag = recorded_by({kFront, kRear});
  std::erase_if(bag.messages, [&](const MemoryBag::Message& message) {
    const double log_s = 1e-9 * static_cast<double>(message.log_ns);
    return bag.topics[message.topic].name == "/rear_scan" && log_s > 102.0 && log_s < 103.0;
  });
  const ReadLog log = read_bag(bag);
  ASSERT_EQ(log.readings.size(), 50U);
  EXPECT_EQ(log.info.sensors.size(), 1U);
  EXPECT_TRUE(is_told(log, "10 times a laser of the group had no sweep"));
  EXPECT_TRUE(std::isnan(log.readings[25].ranges_m.back()));
  EXPECT_FALSE(std::isnan(log.readings[25].ranges_m.front()));
  EXPECT_LT(off_walls_m(log), 0.003);
}

TEST(SeveralLasers, AreOneReadingAgainInARecordingThatIsWrittenOfThem) {
  const ReadLog log = read_bag(recorded_by({kFront, kRear}));
  for (const std::string name : {"m.mcap", "m.bag", "m.clf"}) {
    const TemporaryFolder folder;
    const auto writer = create_mission(folder / name, *log.readings[0].sensor, {});
    for (const RangeReading& reading : log.readings) {
      writer->write(OdometryStep{reading.timestamp_s, reading.odom_from_robot, 0.0, 0.0});
      writer->write(reading);
    }
    writer->finish();
    const ReadLog again = read_log(folder / name);
    const bool are_joined = name != "m.clf";
    ASSERT_EQ(again.readings.size(), are_joined ? 50U : 100U) << name;
    EXPECT_LT(off_walls_m(again), 0.003) << name;
    if (!are_joined) continue;
    for (std::size_t i = 0; i < 50; ++i) {
      ASSERT_EQ(again.readings[i].ranges_m.size(), log.readings[i].ranges_m.size());
      for (std::size_t beam = 0; beam < log.readings[i].ranges_m.size(); ++beam) {
        const float written_m = log.readings[i].ranges_m[beam];
        const float read_m = again.readings[i].ranges_m[beam];
        ASSERT_TRUE(read_m == written_m || (std::isnan(read_m) && std::isnan(written_m)));
      }
    }
  }
}

/// Rays begin where their laser is, and surfaces are not joined over two lasers.
TEST(SeveralLasers, AScanKnowsWhereEachOnesRaysBegin) {
  const ReadLog log = read_bag(recorded_by({kFront, kRear}));
  const Scan scan = scan_of(log.readings[0], {});
  ASSERT_EQ(scan.further.size(), 1U);
  EXPECT_EQ(scan.further[0].first_point, 241U);
  EXPECT_NEAR((scan.sensor - kFront.mount.position()).norm(), 0.0, 1e-9);
  EXPECT_NEAR((scan.further[0].sensor - kRear.mount.position()).norm(), 0.0, 1e-9);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Point2 from = i < 241 ? scan.sensor : scan.further[0].sensor;
    EXPECT_GE(scan.points[i].normal.dot(from - scan.points[i].position), 0.0);
  }
}

}  // namespace
}  // namespace roomatlas::test
