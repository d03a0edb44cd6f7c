// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/bags/memory_bag.hpp"
#include "simulate/simulated.hpp"

#include "roomatlas/io/maps/read_world.hpp"

#include <random>
#include <string>
#include <vector>

namespace roomatlas::test {

/// A gyro as a test's recording has it.
struct GyroFields {
  std::string topic = "/imu";
  double gain = 1.0;
  double drift_rad_per_s = 0.0;
  double noise_rad_per_s = 0.0;
  double roll_rad = 0.0;  ///< pi: upside down
  double rate_hz = 100.0;
  bool has_tf = true;
};

[[nodiscard]] inline std::vector<std::byte> imu_bytes(double stamp_s, const std::string& frame,
                                                      const Eigen::Vector3d& turn_rad_per_s,
                                                      double covariance = 0.0) {
  MessageBytes out(Layout::ros1);
  out.header(stamp_s, frame).add(0.0).add(0.0).add(0.0).add(1.0);
  for (int i = 0; i < 9; ++i) out.add(0.0);
  for (const double turn : turn_rad_per_s) out.add(turn);
  out.add(covariance);
  for (int i = 0; i < 8 + 3 + 9; ++i) out.add(0.0);
  return out.bytes;
}

/// A robot that goes round in a room of a small world with a laser, five times.
/// @param both_ways every second time clockwise
inline std::vector<SimulatedStep> rounds(const OdometryErrors& odometry, bool both_ways = false) {
  SimulationOptions options;
  options.sensor = SensorKind::laser;
  options.odometry = odometry;
  options.start_timestamp_s = 1000.0;
  Drive drive;
  const Drive corners = {{1.2, 1.2}, {3.0, 1.3}, {2.8, 3.0}, {1.3, 2.8}};
  for (int round = 0; round < 5; ++round) {
    const bool is_reversed = both_ways && round % 2 == 1;
    for (std::size_t i = 0; i < 4; ++i) drive.push_back(corners[is_reversed ? 3 - i : i]);
  }
  const Path world = Path(ROOMATLAS_SOURCE_DIR) / "data/worlds/two_rooms.geojson";
  return testing_simulate::run(read_world(world, {}), drive, options);
}

inline ScanFields fields_of(const RangeReading& reading) {
  ScanFields scan;
  scan.stamp_s = reading.timestamp_s;
  scan.angle_min = static_cast<float>(-kPi / 2.0);
  scan.angle_increment = static_cast<float>(radians(1.0));
  scan.range_max = static_cast<float>(reading.sensor->max_range_m);
  scan.ranges = reading.ranges_m;
  return scan;
}

constexpr double kStandsS = 4.0;  // before the first step

inline MemoryBag bag_of(const std::vector<SimulatedStep>& steps,
                        const std::vector<GyroFields>& gyros, bool has_odometry = true) {
  MemoryBag bag;
  const double start_s = steps.front().reading.timestamp_s;
  bag.tf(start_s - kStandsS, {{"base_link", "laser", {0.1, 0.0, 0.0}}}, "/tf_static");
  for (const GyroFields& gyro : gyros) {
    if (!gyro.has_tf) continue;
    bag.tf(start_s - kStandsS,
           {{"base_link", gyro.topic.substr(1) + "_link", {0.05, 0.0, 0.0}, gyro.roll_rad}},
           "/tf_static");
  }
  const auto add = [&](const SimulatedStep& step, double time_s) {
    ScanFields scan = fields_of(step.reading);
    scan.stamp_s = time_s;
    if (has_odometry) bag.odometry(time_s, step.odometry.odom_from_robot);
    bag.scan(time_s, scan);
  };
  for (double time_s = start_s - kStandsS; time_s < start_s - 0.05; time_s += 0.1) {
    add(steps.front(), time_s);
  }
  for (const SimulatedStep& step : steps) add(step, step.reading.timestamp_s);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const GyroFields& gyro : gyros) {
    std::size_t next = 1;
    for (double time_s = start_s - kStandsS; time_s < steps.back().reading.timestamp_s;
         time_s += 1.0 / gyro.rate_hz) {
      while (next + 1 < steps.size() && steps[next].reading.timestamp_s < time_s) ++next;
      const SimulatedStep& a = steps[next - 1];
      const SimulatedStep& b = steps[next];
      const double turn =
          wrap_angle(b.truth.world_from_robot.theta_rad - a.truth.world_from_robot.theta_rad);
      double rate = time_s < start_s ? 0.0 : turn / (b.reading.timestamp_s - a.reading.timestamp_s);
      rate = gyro.gain * rate + gyro.drift_rad_per_s + gyro.noise_rad_per_s * normal(random);
      const Eigen::Vector3d about(0.01, -0.02, gyro.roll_rad > 1.0 ? -rate : rate);
      bag.add(gyro.topic, "sensor_msgs/Imu", time_s,
              imu_bytes(time_s, gyro.topic.substr(1) + "_link", about));
    }
  }
  return bag;
}

}  // namespace roomatlas::test
