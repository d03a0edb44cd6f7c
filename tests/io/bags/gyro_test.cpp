// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/steered_odometry.hpp"
#include "io/bags/gyro_bag.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace roomatlas::test {
namespace {

/// Turns are reported a sixth too large.
const OdometryErrors kBad{0.0, 0.0, 0.5, 1.0 / 6.0};
const OdometryErrors kGood{0.0, 0.0, 0.3, 0.0};
const GyroFields kDrifting{.drift_rad_per_s = 0.02, .noise_rad_per_s = 0.005};

/// How far the heading is off the truth at most, from where the mission begins.
double most_off_rad(const ReadLog& log, const std::vector<SimulatedStep>& steps) {
  double most_rad = 0.0;
  std::size_t at = 0;
  for (const RangeReading& reading : log.readings) {
    while (at < steps.size() && steps[at].reading.timestamp_s < reading.timestamp_s - 1e-6) ++at;
    if (at == steps.size() || steps[at].reading.timestamp_s > reading.timestamp_s + 1e-6) continue;
    const double told = wrap_angle(reading.odom_from_robot.theta_rad -
                                   log.readings.front().odom_from_robot.theta_rad);
    const double is = wrap_angle(steps[at].truth.world_from_robot.theta_rad -
                                 steps.front().truth.world_from_robot.theta_rad);
    most_rad = std::max(most_rad, std::abs(wrap_angle(told - is)));
  }
  return most_rad;
}

bool says(const ReadLog& log, const std::string& words) {
  return log.info.recording->choice.find(words) != std::string::npos;
}

TEST(Gyro, TurnsWhereOdometryIsWorse) {
  const std::vector<SimulatedStep> steps = rounds(kBad);
  const ReadLog without = read_bag(bag_of(steps, {}));
  EXPECT_GT(most_off_rad(without, steps), radians(60.0));
  const ReadLog log = read_bag(bag_of(steps, {kDrifting}));
  EXPECT_TRUE(says(log, "turns of the gyro /imu (off the sweeps' by "))
      << log.info.recording->choice;
  EXPECT_LT(most_off_rad(log, steps), radians(3.0));
  EXPECT_EQ(log.readings.size(), without.readings.size());
  EXPECT_NEAR(log.info.path_length_m, without.info.path_length_m, 0.02 * log.info.path_length_m);
  for (const RecordedTopic& topic : log.info.recording->topics) {
    EXPECT_EQ(topic.use == "gyro", topic.name == "/imu");
  }
}

TEST(Gyro, IsNotTakenWhereOdometryTurnsWell) {
  const std::vector<SimulatedStep> steps = rounds(kGood);
  const ReadLog without = read_bag(bag_of(steps, {}));
  GyroFields poor{.gain = 0.9, .noise_rad_per_s = 0.02};
  GyroFields wandering{.noise_rad_per_s = 1.0, .rate_hz = 25.0};
  for (const GyroFields& gyro : {poor, wandering}) {
    const ReadLog log = read_bag(bag_of(steps, {gyro}));
    EXPECT_TRUE(says(log, "turns of odometry (off the sweeps' by ")) << log.info.recording->choice;
    ASSERT_EQ(log.readings.size(), without.readings.size());
    for (std::size_t i = 0; i < log.readings.size(); ++i) {
      ASSERT_EQ(log.readings[i].odom_from_robot, without.readings[i].odom_from_robot);
    }
  }
}

TEST(Gyro, UpsideDownIsToldByTfOrByTheSweeps) {
  const std::vector<SimulatedStep> steps = rounds(kBad);
  for (const bool has_tf : {true, false}) {
    for (const double roll_rad : {0.0, kPi}) {
      GyroFields gyro = kDrifting;
      gyro.roll_rad = roll_rad;
      gyro.has_tf = has_tf;
      const ReadLog log = read_bag(bag_of(steps, {gyro}));
      EXPECT_TRUE(says(log, "turns of the gyro /imu (off")) << log.info.recording->choice;
      EXPECT_LT(most_off_rad(log, steps), radians(3.0)) << has_tf << " " << roll_rad;
    }
  }
}

TEST(Gyro, OfSeveralTheBetterOneTurns) {
  const std::vector<SimulatedStep> steps = rounds(kBad);
  GyroFields poor{.topic = "/camera_imu", .gain = 0.95, .noise_rad_per_s = 0.05};
  const ReadLog log = read_bag(bag_of(steps, {poor, kDrifting}));
  EXPECT_TRUE(says(log, "turns of the gyro /imu (off")) << log.info.recording->choice;
}

TEST(Gyro, IsForbiddenAndForcedByItsOption) {
  const std::vector<SimulatedStep> bad = rounds(kBad);
  MissionOptions options;
  options.recording.imu_topic = "none";
  const ReadLog forbidden = read_bag(bag_of(bad, {kDrifting}), options);
  EXPECT_FALSE(says(forbidden, "turns of"));
  EXPECT_GT(most_off_rad(forbidden, bad), radians(60.0));

  const std::vector<SimulatedStep> good = rounds(kGood);
  options.recording.imu_topic = "imu";
  const ReadLog forced = read_bag(bag_of(good, {kDrifting}), options);
  EXPECT_TRUE(says(forced, "turns of the gyro /imu as told")) << forced.info.recording->choice;
  EXPECT_LT(most_off_rad(forced, good), radians(3.0));
  options.recording.imu_topic = "/scan";
  EXPECT_THROW((void)read_bag(bag_of(good, {kDrifting}), options), UsageError);
}

TEST(Gyro, TurnsARobotThatHasNoOdometry) {
  const std::vector<SimulatedStep> steps = rounds(kGood);
  const ReadLog without = read_bag(bag_of(steps, {}, false));
  EXPECT_EQ(without.info.recording->gyro_topic, "");
  const ReadLog log = read_bag(bag_of(steps, {kDrifting}, false));
  EXPECT_EQ(log.info.odometry, "none");
  EXPECT_EQ(log.info.recording->gyro_topic, "/imu") << log.info.recording->choice;
  EXPECT_TRUE(says(log, "no odometry: by scan matching alone"));
  EXPECT_TRUE(says(log, "turns of the gyro /imu (off the sweeps' by "));
  EXPECT_LT(most_off_rad(log, steps), radians(3.0));
  ASSERT_EQ(log.readings.size(), without.readings.size());
  for (const RangeReading& reading : log.readings) {
    EXPECT_EQ(reading.odom_from_robot.position(), Point2(0.0, 0.0));
  }
  GyroFields wandering{.noise_rad_per_s = 20.0, .rate_hz = 25.0};
  const ReadLog poor = read_bag(bag_of(steps, {wandering}, false));
  EXPECT_EQ(poor.info.recording->gyro_topic, "") << poor.info.recording->choice;
}

TEST(Gyro, ThatItsMessagesSayIsNotThereIsNotUsed) {
  MemoryBag bag = bag_of(rounds(kBad), {});
  for (int i = 0; i < 400; ++i) {
    bag.add("/imu", "sensor_msgs/Imu", 996.0 + 0.02 * i,
            imu_bytes(996.0 + 0.02 * i, "imu_link", {0.0, 0.0, 0.0}, -1.0));
  }
  EXPECT_FALSE(says(read_bag(bag), "turns of"));
}

/// By the arithmetic of an arc: odometry that does not turn at all, and a gyro that does.
TEST(SteeredOdometry, PutsTheGyrosTurnIntoEachStep) {
  io::SteeredOdometry steered({0, Eigen::Vector3d::UnitZ(), 0.0});
  constexpr std::int64_t kMs = 1'000'000;
  constexpr double kRate = 0.5;  // rad/s, at 1 m/s: a circle of 2 m
  for (int i = 0; i <= 200; ++i) {
    if (i % 10 == 0) steered.add_odometry(i * 10 * kMs, {0.01 * i, 0.0, 0.0});
    steered.add_turn(i * 10 * kMs, {0.0, 0.0, kRate});
  }
  for (const double time_s : {0.0, 0.3, 0.955, 1.7, 2.0}) {
    const auto at = steered.at(static_cast<std::int64_t>(1e9 * time_s));
    ASSERT_TRUE(at);
    EXPECT_EQ(at->beyond_ns, 0);
    const Pose2 pose = io::planar(at->transform);
    EXPECT_NEAR(pose.theta_rad, kRate * time_s, 1e-9);
    EXPECT_NEAR(pose.x_m, std::sin(kRate * time_s) / kRate, 2e-3);
    EXPECT_NEAR(pose.y_m, (1.0 - std::cos(kRate * time_s)) / kRate, 2e-3);
  }
  EXPECT_EQ(steered.steps_without_gyro(), 0);
}

TEST(SteeredOdometry, KeepsOdometrysTurnWhereTheGyroIsSilent) {
  io::SteeredOdometry steered({0, Eigen::Vector3d::UnitZ(), 0.0});
  constexpr std::int64_t kMs = 1'000'000;
  for (int i = 0; i <= 400; ++i) {
    if (i % 10 == 0) steered.add_odometry(i * 10 * kMs, {0.0, 0.0, 0.001 * i});
    if (i < 100 || i > 200) steered.add_turn(i * 10 * kMs, {0.0, 0.0, 0.2});
  }
  EXPECT_EQ(steered.steps_without_gyro(), 12);  // 0.9 s to 2.1 s
  const Pose2 end = io::planar(steered.at(4'000 * kMs)->transform);
  EXPECT_NEAR(end.theta_rad, 0.2 * (4.0 - 1.2) + 0.1 * 1.2, 1e-9);
}

TEST(SteeredOdometry, LearnsTheDriftWhereOdometryStands) {
  io::SteeredOdometry steered({0, Eigen::Vector3d::UnitZ(), 0.0});
  constexpr std::int64_t kMs = 1'000'000;
  constexpr double kDrift = 0.01;
  for (int i = 0; i <= 6000; ++i) {
    if (i % 10 == 0) steered.add_odometry(i * 10 * kMs, {});
    steered.add_turn(i * 10 * kMs, {0.0, 0.0, kDrift});
  }
  const double later = io::planar(steered.at(60'000 * kMs)->transform).theta_rad -
                       io::planar(steered.at(51'000 * kMs)->transform).theta_rad;
  EXPECT_LT(std::abs(later), 0.02 * kDrift * 9.0);
}

}  // namespace
}  // namespace roomatlas::test
