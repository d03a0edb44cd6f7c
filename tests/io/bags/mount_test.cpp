// SPDX-License-Identifier: GPL-3.0-or-later
// Mounts of lasers that no tf tells.
#include "io/bags/gyro_bag.hpp"

#include "roomatlas/match/sensor_mount.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace roomatlas::test {
namespace {

/// As recorded by a laser whose frame is turned against the robot, without a word of where it is.
MemoryBag without_mount(const std::vector<SimulatedStep>& steps, double frame_turned_rad) {
  MemoryBag bag;
  for (const SimulatedStep& step : steps) {
    ScanFields scan = fields_of(step.reading);
    scan.angle_min -= static_cast<float>(frame_turned_rad);
    scan.frame = "lidar";
    bag.odometry(scan.stamp_s, step.odometry.odom_from_robot).scan(scan.stamp_s, scan);
  }
  return bag;
}

TEST(Mount, IsFoundByTheSweepsWhereNoTfTellsIt) {
  const std::vector<SimulatedStep> steps = rounds({0.005, 0.2, 0.5, 0.01}, true);
  for (const double turned_deg : {0.0, 90.0, -170.0}) {
    const ReadLog log = read_bag(without_mount(steps, radians(turned_deg)));
    ASSERT_EQ(log.readings.size(), steps.size());
    EXPECT_TRUE(is_told(log, "no tf tells where the laser sits"));
    EXPECT_NE(log.info.recording->choice.find("found by its sweeps"), std::string::npos);
    const std::vector<Pose2>& beams = log.readings[0].sensor->robot_from_beam;
    EXPECT_NEAR(beams[90].x_m, 0.1, 0.02) << turned_deg;
    EXPECT_NEAR(beams[90].y_m, 0.0, 0.02) << turned_deg;
    EXPECT_NEAR(beams[90].theta_rad, 0.0, radians(1.5)) << turned_deg;
  }
}

TEST(Mount, IsNotGuessedWhereTurnsGoOneWayOrOdometryIsBad) {
  EXPECT_THROW((void)read_bag(without_mount(rounds({0.0, 0.0, 0.5, 0.0}), 0.0)), InputError);
  const OdometryErrors bad{0.2, 0.0, 0.5, 1.0 / 6.0};
  EXPECT_THROW((void)read_bag(without_mount(rounds(bad, true), 0.0)), InputError);
}

/// By the definition: motions made from a mount give it back.
TEST(Mount, OfExactMotionsIsExact) {
  const Pose2 mount{0.21, -0.13, 2.1};
  std::vector<SeenMotion> motions;
  for (int i = 0; i < 20; ++i) {
    const Pose2 robot{0.1 + 0.02 * i, 0.05 * std::sin(i), 0.6 * std::sin(1.7 * i)};
    motions.push_back({robot, inverse(mount) * robot * mount});
  }
  const auto found = mount_from_motions(motions);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->robot_from_sensor.x_m, mount.x_m, 1e-9);
  EXPECT_NEAR(found->robot_from_sensor.y_m, mount.y_m, 1e-9);
  EXPECT_NEAR(found->robot_from_sensor.theta_rad, mount.theta_rad, 1e-9);
  EXPECT_NEAR(found->length_scale, 1.0, 1e-9);
  for (SeenMotion& motion : motions) motion.of_robot.theta_rad = motion.of_sensor.theta_rad = 0.0;
  EXPECT_FALSE(mount_from_motions(motions));  // without turns there is no lever arm
}

}  // namespace
}  // namespace roomatlas::test
