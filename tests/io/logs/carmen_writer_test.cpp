// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mission_log.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <memory>
#include "roomatlas/io/logs/carmen_writer.hpp"

namespace roomatlas {
namespace {

using test::bytes_of;
using test::read_log;
using test::TemporaryFolder;

std::shared_ptr<RangeSensor> ring_of_three() {
  auto ring = std::make_shared<RangeSensor>();
  ring->kind = SensorKind::sonar;
  ring->half_cone_rad = radians(10.0);
  ring->max_range_m = 4.7;  // not a float
  ring->robot_from_beam = {{0.2, 0.1, kPi / 3}, {0.22, 0, 0}, {0.2, -0.1, -kPi / 3}};
  return ring;
}

SimulatedStep step_at(int i, const std::shared_ptr<const RangeSensor>& ring) {
  const double time_s = 1000000000.0 + 0.1 * i;
  const Pose2 odometry{0.04 * i, 1.0 / 3.0, wrap_angle(0.01 * i)};
  SimulatedStep step;
  step.odometry = {time_s, odometry, 0.4, 0.1};
  step.reading = {time_s, odometry, ring, {0.1F + 0.01F * static_cast<float>(i), 2.345678F, 1.0F}};
  step.truth = {time_s, {0.05 * i, 0.0, wrap_angle(0.02 * i)}};
  return step;
}

TEST(CarmenWriter, WhatItWritesReadsBackToTheSameBits) {
  const TemporaryFolder folder;
  const auto ring = ring_of_three();
  CarmenWriter writer(folder / "mission.clf", *ring, {0.51, 0.38});
  for (int i = 0; i < 200; ++i) writer.write(step_at(i, ring));
  writer.finish();

  const test::ReadLog log = read_log(folder / "mission.clf");
  ASSERT_EQ(log.readings.size(), 200U);
  ASSERT_EQ(log.true_poses.size(), 200U);
  for (int i = 0; i < 200; ++i) {
    const SimulatedStep step = step_at(i, ring);
    const RangeReading& reading = log.readings[static_cast<std::size_t>(i)];
    const TruePose& truth = log.true_poses[static_cast<std::size_t>(i)];
    EXPECT_EQ(reading.timestamp_s, step.reading.timestamp_s);
    EXPECT_EQ(reading.odom_from_robot, step.odometry.odom_from_robot);
    EXPECT_EQ(reading.ranges_m, step.reading.ranges_m);
    EXPECT_EQ(truth.timestamp_s, step.truth.timestamp_s);
    EXPECT_EQ(truth.world_from_robot, step.truth.world_from_robot);
  }
  ASSERT_EQ(log.info.sensors.size(), 1U);
  EXPECT_EQ(log.info.sensors[0]->robot_from_beam, ring->robot_from_beam);
  EXPECT_EQ(log.info.sensors[0]->half_cone_rad, ring->half_cone_rad);
  EXPECT_NEAR(log.info.sensors[0]->max_range_m, 4.7, 1e-6);
  EXPECT_EQ(log.info.footprint.length_m, 0.51);
  EXPECT_EQ(log.info.footprint.width_m, 0.38);
  EXPECT_TRUE(log.info.issues.empty());
}

TEST(CarmenWriter, NoEchoReadsBackAsNoEchoAndAMissingMeasurementAsMissing) {
  const TemporaryFolder folder;
  const auto ring = ring_of_three();
  CarmenWriter writer(folder / "mission.clf", *ring, {});
  SimulatedStep step = step_at(0, ring);
  step.reading.ranges_m = {4.7F, 9.0F, std::numeric_limits<float>::quiet_NaN()};
  writer.write(step);
  writer.finish();
  const test::ReadLog log = read_log(folder / "mission.clf");
  const RangeReading& reading = log.readings.at(0);
  EXPECT_GE(reading.ranges_m[0], reading.sensor->max_range_m);
  EXPECT_GE(reading.ranges_m[1], reading.sensor->max_range_m);
  EXPECT_EQ(reading.ranges_m[2], 0.0F);
}

TEST(CarmenWriter, WritesTheLinesAsCarmensLoggerDoes) {
  const TemporaryFolder folder;
  RangeSensor ring;
  ring.kind = SensorKind::sonar;
  ring.half_cone_rad = 0.25;
  ring.max_range_m = 5.0;
  ring.robot_from_beam = {{0.1, 0.2, 0.5}};
  SimulatedStep step;
  step.odometry = {100.5, {1, 2, 0.25}, 0.4, 0};
  step.reading = {100.5, {1, 2, 0.25}, std::make_shared<RangeSensor>(ring), {1.5F}};
  step.truth = {100.5, {3, 4, 0.75}};
  CarmenWriter writer(folder / "mission.clf", ring, {0.5, 0.4});
  writer.write(step);
  writer.finish();
  const std::string text = bytes_of(folder / "mission.clf");
  EXPECT_THAT(text, testing::StartsWith("# CARMEN Logfile\n"));
  EXPECT_THAT(text, testing::EndsWith("PARAM robot_length 0.5 0 simulator 0\n"
                                      "PARAM robot_width 0.4 0 simulator 0\n"
                                      "PARAM robot_max_sonar 5 0 simulator 0\n"
                                      "ODOM 1 2 0.25 0.4 0 0 100.5 simulator 0\n"
                                      "SONAR 0.5 1 1.5 0.1 0.2 0.5 100.5 simulator 0\n"
                                      "TRUEPOS 3 4 0.75 1 2 0.25 100.5 simulator 0\n"));
}

TEST(CarmenWriter, LeavesNothingBehindUnlessItIsFinished) {
  const TemporaryFolder folder;
  const auto ring = ring_of_three();
  {
    CarmenWriter writer(folder / "mission.clf", *ring, {});
    writer.write(step_at(0, ring));
    EXPECT_FALSE(std::filesystem::exists(folder / "mission.clf"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(CarmenWriter, RefusesAStepOfAnotherRing) {
  const TemporaryFolder folder;
  const auto ring = ring_of_three();
  CarmenWriter writer(folder / "mission.clf", *ring, {});
  SimulatedStep step = step_at(0, ring);
  step.reading.ranges_m.pop_back();
  EXPECT_THROW(writer.write(step), std::invalid_argument);
}

}  // namespace
}  // namespace roomatlas
