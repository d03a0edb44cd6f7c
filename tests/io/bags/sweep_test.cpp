// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/sweep.hpp"

#include "io/bags/memory_bag.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace roomatlas::test {
namespace {

constexpr double kHalfRoomM = 4.0;  // a square room around the origin

/// From a pose inside the room to its wall.
double true_range_m(const Pose2& world_from_beam) {
  const Point2 ray = direction(world_from_beam.theta_rad);
  double range_m = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis) {
    for (const double wall : {-kHalfRoomM, kHalfRoomM}) {
      const double at_m = (wall - world_from_beam.position()[axis]) / ray[axis];
      if (at_m > 0.0) range_m = std::min(range_m, at_m);
    }
  }
  return range_m;
}

RangeSensor ring(int beams, const Point2& place) {
  RangeSensor sensor;
  sensor.max_range_m = 10.0;
  const double step_rad = 2.0 * kPi / beams;
  for (int i = 0; i < beams; ++i) {
    sensor.robot_from_beam.push_back({place.x(), place.y(), wrap_angle(-kPi + i * step_rad)});
  }
  return sensor;
}

TEST(Sweep, AResampledSweepMeetsTheWallsWhereTheyAre) {
  const Point2 place(0.3, -0.2);
  const RangeSensor onto = ring(360, place);
  std::vector<SweepRay> rays;  // from another place, with other and uneven bearings
  for (int i = 0; i < 500; ++i) {
    const double bearing = -kPi + 2.0 * kPi * (i + 0.3 * std::sin(i)) / 500.0;
    const Pose2 beam{0.32, -0.17, wrap_angle(bearing)};
    rays.push_back({beam.position(), beam * Point2(true_range_m(beam), 0.0), Echo::surface});
  }
  const std::vector<float> ranges_m = resampled(rays, onto);
  int known = 0;
  int exact = 0;
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    if (std::isnan(ranges_m[i])) continue;
    ++known;
    const double error_m = std::abs(ranges_m[i] - true_range_m(onto.robot_from_beam[i]));
    EXPECT_LT(error_m, 0.05) << i;
    if (error_m < 1e-4) ++exact;
  }
  EXPECT_EQ(known, 360);
  EXPECT_GE(exact, 352);  // all but those beside a corner
}

TEST(Sweep, WhatMetNothingAndWhatIsUnknownStaysSo) {
  const RangeSensor onto = ring(360, {0.0, 0.0});
  std::vector<SweepRay> rays;
  for (int i = 0; i < 360; ++i) {
    const Pose2 beam{0.0, 0.0, wrap_angle(-kPi + 2.0 * kPi * (i + 0.2) / 360.0)};
    const Echo echo = i < 100 ? Echo::nothing : i < 200 ? Echo::unknown : Echo::surface;
    rays.push_back({{0.0, 0.0}, beam * Point2(echo == Echo::surface ? 3.0 : 10.0, 0.0), echo});
  }
  const std::vector<float> ranges_m = resampled(rays, onto);
  EXPECT_EQ(ranges_m[50], 10.0F);
  EXPECT_TRUE(std::isnan(ranges_m[150]));
  EXPECT_NEAR(ranges_m[300], 3.0F, 1e-3);
}

TEST(Sweep, AnEdgeIsNoSurfaceFromNearToFar) {
  const RangeSensor onto = ring(720, {0.0, 0.0});
  std::vector<SweepRay> rays;
  for (int i = 0; i < 360; ++i) {
    const Pose2 beam{0.0, 0.0, wrap_angle(-kPi + 2.0 * kPi * (i + 0.1) / 360.0)};
    rays.push_back({{0.0, 0.0}, beam * Point2(i < 180 ? 1.0 : 5.0, 0.0), Echo::surface});
  }
  for (const float range_m : resampled(rays, onto)) {
    EXPECT_TRUE(std::abs(range_m - 1.0F) < 0.01F || std::abs(range_m - 5.0F) < 0.01F) << range_m;
  }
}

/// A rotating laser, ten turns a second, on a robot that turns and drives; its scans as it would
/// have taken them beam by beam.
ReadLog turning_robot(float time_increment, float scan_time) {
  constexpr int kBeams = 360;
  constexpr double kSweepS = 0.1;
  const Pose2 robot_from_laser{0.15, 0.05, kPi / 2.0};
  const auto robot_at = [](double time_s) {
    return Pose2{0.6 * std::cos(time_s), 0.6 * std::sin(time_s), wrap_angle(1.3 * time_s)};
  };
  MemoryBag bag(Layout::cdr_little);
  bag.tf(0.5, {{"base_link", "laser", robot_from_laser}}, "/tf_static");
  for (int i = 0; i <= 400; ++i) bag.odometry(1.0 + i / 100.0, robot_at(1.0 + i / 100.0));
  for (int sweep = 0; sweep < 36; ++sweep) {
    const double start_s = 1.0 + sweep * kSweepS;
    ScanFields scan;
    scan.stamp_s = start_s;
    scan.angle_min = static_cast<float>(-kPi);
    scan.angle_increment = static_cast<float>(2.0 * kPi / kBeams);
    scan.time_increment = time_increment;
    scan.scan_time = scan_time;
    scan.range_max = 12.0F;
    scan.ranges.clear();
    for (int i = 0; i < kBeams; ++i) {
      const Pose2 laser = robot_at(start_s + i * kSweepS / kBeams) * robot_from_laser;
      const Pose2 beam = laser * Pose2{0.0, 0.0, wrap_angle(-kPi + 2.0 * kPi * i / kBeams)};
      scan.ranges.push_back(static_cast<float>(true_range_m(beam)));
    }
    bag.scan(start_s + kSweepS, scan);
  }
  return read_bag(bag);
}

/// How far the ends of all beams are from the room's walls, on average.
double mean_miss_m(const ReadLog& log) {
  double sum_m = 0.0;
  int ends = 0;
  for (const RangeReading& reading : log.readings) {
    for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
      if (!(reading.ranges_m[i] < reading.sensor->max_range_m)) continue;
      const Pose2 beam = reading.odom_from_robot * reading.sensor->robot_from_beam[i];
      sum_m += std::abs(true_range_m(beam) - static_cast<double>(reading.ranges_m[i]));
      ++ends;
    }
  }
  return sum_m / ends;
}

TEST(Sweep, EachBeamOfATurningRobotIsPutToItsOwnPose) {
  const double rigid_m = mean_miss_m(turning_robot(0.0F, 0.0F));
  const ReadLog by_increment = turning_robot(0.1F / 360.0F, 0.1F);
  const ReadLog by_turn = turning_robot(0.0F, 0.1F);
  EXPECT_GT(rigid_m, 0.05);  // the test could fail
  EXPECT_LT(mean_miss_m(by_increment), 0.004);
  EXPECT_LT(mean_miss_m(by_turn), 0.004);
  ASSERT_EQ(by_increment.readings.size(), 36U);
  EXPECT_EQ(by_increment.info.sensors.size(), 1U);
  EXPECT_TRUE(is_told(by_increment, "each beam is put to its own pose"));
}

TEST(Sweep, ALaserWhoseBeamsKeepChangingHasFewSensors) {
  MemoryBag bag;
  bag.tf(0.5, {{"base_link", "laser", {}}}, "/tf_static");
  for (int i = 0; i <= 100; ++i) bag.odometry(1.0 + i / 20.0, {0.0, 0.0, 0.0});
  for (int sweep = 0; sweep < 40; ++sweep) {
    const int beams = 340 + sweep;
    ScanFields scan;
    scan.angle_min = static_cast<float>(-kPi);
    scan.angle_increment = static_cast<float>(2.0 * kPi / beams);
    scan.ranges.clear();
    for (int i = 0; i < beams; ++i) {
      scan.ranges.push_back(
          static_cast<float>(true_range_m({0.0, 0.0, wrap_angle(-kPi + 2.0 * kPi * i / beams)})));
    }
    bag.scan(1.0 + sweep / 10.0, scan);
  }
  const ReadLog log = read_bag(bag);
  ASSERT_EQ(log.readings.size(), 40U);
  EXPECT_LE(log.info.sensors.size(), 8U);
  EXPECT_LT(mean_miss_m(log), 0.002);
  EXPECT_TRUE(is_told(log, "keep changing"));
}

/// A laser that is turned to and fro by hand, without odometry; its beams come one after the other,
/// as its messages say or the other way round.
MemoryBag swung_laser(double told_s, bool is_reversed) {
  MemoryBag bag;
  for (int i = 0; i < 300; ++i) {
    const double stamp_s = 100.0 + 0.1 * i;
    ScanFields scan;
    scan.angle_min = static_cast<float>(-kPi);
    scan.angle_increment = static_cast<float>(2.0 * kPi / 360.0);
    scan.time_increment = static_cast<float>(told_s / 359.0);
    scan.range_max = 20.0F;
    scan.ranges.clear();
    for (int beam = 0; beam < 360; ++beam) {
      const double share = (is_reversed ? 359 - beam : beam) / 359.0;
      const double time_s = 0.1 * i + 0.1 * share;
      const Pose2 laser{0.6 * std::sin(0.7 * time_s), 0.5, 0.8 * std::sin(1.2 * time_s)};
      const Pose2 ray = laser * Pose2{0.0, 0.0, -kPi + 2.0 * kPi * beam / 360.0};
      scan.ranges.push_back(static_cast<float>(true_range_m(ray)));
    }
    bag.scan(stamp_s, scan);
  }
  return bag;
}

TEST(Sweep, TheOrderOfBeamsWithoutOdometryIsToldByTheWalls) {
  const auto order_of = [](const MemoryBag& bag) {
    const ReadLog log = read_bag(bag);
    return std::pair(log.readings.at(5).sweep_s, log.info.recording->choice);
  };
  const auto [as_told_s, as_told] = order_of(swung_laser(0.1, false));
  EXPECT_NEAR(as_told_s, 0.1, 1e-6);
  EXPECT_NE(as_told.find("beams put to their own times"), std::string::npos) << as_told;
  const auto [reversed_s, reversed] = order_of(swung_laser(0.1, true));
  EXPECT_NEAR(reversed_s, -0.1, 1e-6);
  EXPECT_NE(reversed.find("in the reverse of the order"), std::string::npos) << reversed;
  EXPECT_EQ(order_of(swung_laser(0.0, false)).first, 0.0);
}

TEST(Sweep, TheOrderOfBeamsThatRotateIsToldByTheWallsWithOdometryToo) {
  for (const bool is_reversed : {false, true}) {
    MemoryBag bag = swung_laser(0.1, is_reversed);
    bag.tf(99.0, {{"base_link", "laser", {}}}, "/tf_static");
    for (int i = -20; i < 640; ++i) {
      const double time_s = 0.05 * i;
      bag.odometry(100.0 + time_s,
                   {0.6 * std::sin(0.7 * time_s), 0.5, 0.8 * std::sin(1.2 * time_s)});
    }
    const ReadLog log = read_bag(bag);
    const std::string& choice = log.info.recording->choice;
    EXPECT_EQ(choice.find("in the reverse of the order") != std::string::npos, is_reversed)
        << choice;
    EXPECT_LT(mean_miss_m(log), 0.01);
  }
}

/// How a driver tells a point's time.
struct TimeField {
  std::string name;
  int datatype = 7;
  double unit_s = 1.0;
  bool is_absolute = false;
};

/// The room about a robot that turns by 70 degrees a second, as a rotating lidar's cloud.
MemoryBag turning_cloud(const TimeField& time) {
  constexpr double kSweepS = 0.1;
  const auto robot_at = [](double time_s) {
    return Pose2{0.0, 0.0, wrap_angle(radians(70.0) * (time_s - 100.0))};
  };
  MemoryBag bag;
  bag.tf(99.0, {{"base_link", "lidar", {0.0, 0.0, 0.0}, 0.0, 0.5}}, "/tf_static");
  for (int i = 0; i <= 60; ++i) bag.odometry(100.0 + i / 20.0, robot_at(100.0 + i / 20.0));
  for (int i = 0; i < 20; ++i) {
    const double stamp_s = 100.1 + i / 10.0;
    constexpr std::uint32_t kPoints = 360;
    constexpr std::uint32_t kPointBytes = 20;
    MessageBytes out(Layout::ros1);
    out.header(stamp_s, "lidar").add(std::uint32_t{1}).add(kPoints).add(std::uint32_t{4});
    std::uint32_t offset = 0;
    for (const std::string& name : {std::string("x"), std::string("y"), std::string("z")}) {
      out.text(name).add(offset).add(std::uint8_t{7}).add(std::uint32_t{1});
      offset += 4;
    }
    out.text(time.name).add(offset).add(static_cast<std::uint8_t>(time.datatype));
    out.add(std::uint32_t{1}).add(std::uint8_t{0}).add(kPointBytes).add(kPoints * kPointBytes);
    out.add(kPoints * kPointBytes);
    for (std::uint32_t point = 0; point < kPoints; ++point) {
      const double passed_s = kSweepS * point / kPoints;
      const double angle_rad = radians(static_cast<double>(point) - 180.0);
      const Pose2 beam{0.0, 0.0, angle_rad};
      const double range_m = true_range_m(robot_at(stamp_s + passed_s) * beam);
      const Point2 end = beam * Point2(range_m, 0.0);
      out.add(static_cast<float>(end.x())).add(static_cast<float>(end.y())).add(0.0F);
      const double told = ((time.is_absolute ? stamp_s : 0.0) + passed_s) / time.unit_s;
      if (time.datatype == 8) {
        out.add(told);
      } else {
        if (time.datatype == 7) out.add(static_cast<float>(told));
        if (time.datatype == 6) out.add(static_cast<std::uint32_t>(told));
        out.add(std::uint32_t{0});
      }
    }
    out.add(std::uint8_t{1});
    bag.add("/points", "sensor_msgs/PointCloud2", stamp_s, out.bytes);
  }
  return bag;
}

TEST(Sweep, EachPointOfATurningCloudIsPutToItsOwnPose) {
  EXPECT_GT(mean_miss_m(read_bag(turning_cloud({"intensity"}))), 0.05);
  for (const TimeField& time :
       {TimeField{"time"}, TimeField{"t", 6, 1e-9}, TimeField{"offset_time", 6, 1e-6},
        TimeField{"timestamp", 8, 1.0, true}, TimeField{"timestamp", 8, 1e-9, true}}) {
    const ReadLog log = read_bag(turning_cloud(time));
    EXPECT_EQ(log.readings.size(), 20U);
    EXPECT_LT(mean_miss_m(log), 0.02) << time.name << " " << time.datatype;
    EXPECT_TRUE(is_told(log, "each point is put to its own pose"));
  }
}

TEST(Sweep, ACloudGivesTheNearestPointOfEachBearingInItsBand) {
  MemoryBag bag;
  bag.tf(0.5, {{"base_link", "lidar", {0.2, 0.0, 0.0}, 0.0, 0.5}}, "/tf_static");
  for (int i = 0; i <= 40; ++i) bag.odometry(1.0 + i / 20.0, {i / 20.0, 0.0, 0.0});
  for (int i = 0; i < 15; ++i) {
    MessageBytes out(Layout::ros1);
    const double time_s = 1.0 + i / 10.0;
    out.header(time_s, "lidar").add(std::uint32_t{1}).add(std::uint32_t{4}).add(std::uint32_t{3});
    std::uint32_t offset = 0;
    for (const char* name : {"x", "y", "z"}) {
      out.text(name).add(offset).add(std::uint8_t{7}).add(std::uint32_t{1});
      offset += 4;
    }
    out.add(std::uint8_t{0}).add(std::uint32_t{12}).add(std::uint32_t{48}).add(std::uint32_t{48});
    // a wall, a nearer thing at a robot's height, the floor before it, a lamp above
    for (const float value :
         {5.0F, 0.08F, 0.0F, 3.0F, 0.05F, 0.4F, 1.0F, 0.02F, -0.5F, 2.0F, 0.03F, 1.5F}) {
      out.add(value);
    }
    out.add(std::uint8_t{1});
    bag.add("/points", "sensor_msgs/PointCloud2", time_s, out.bytes);
  }
  const ReadLog log = read_bag(bag);
  ASSERT_EQ(log.readings.size(), 15U);
  std::vector<float> seen;
  for (const float range_m : log.readings[3].ranges_m) {
    if (!std::isnan(range_m)) seen.push_back(range_m);
  }
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_NEAR(seen[0], std::hypot(3.0, 0.05), 1e-5);
  EXPECT_TRUE(is_told(log, "m above the plane of base_link"));
}

}  // namespace
}  // namespace roomatlas::test
