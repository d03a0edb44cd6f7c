// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/output_file.hpp"
#include "text/numbers.hpp"

#include "roomatlas/io/logs/carmen_writer.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace roomatlas {
namespace {

constexpr const char* kHost = "simulator";

void append_numbers(std::string& line, std::initializer_list<double> values) {
  for (const double value : values) {
    line += ' ';
    io::append_number(line, value);
  }
}

void append_pose(std::string& line, const Pose2& pose) {
  append_numbers(line, {pose.x_m, pose.y_m, pose.theta_rad});
}

/// No echo is written as the limit, a missing measurement as 0.
void append_range(std::string& line, float range_m, double max_range_m) {
  line += ' ';
  const auto limit_m = static_cast<float>(max_range_m);
  if (!std::isfinite(range_m) || range_m <= 0.0F) {
    line += '0';
  } else {
    io::append_number(line, range_m < limit_m ? range_m : limit_m);
  }
}

std::string parameter_line(const char* name, double value) {
  std::string line = std::string("PARAM ") + name;
  append_numbers(line, {value, 0.0});
  return line + " " + kHost + " 0\n";
}

/// FLASER lines carry no bearings: readers take 181 beams as one a degree from -90 to 90.
void require_front_laser(const RangeSensor& sensor) {
  if (sensor.kind != SensorKind::laser) return;
  const std::vector<Pose2>& beams = sensor.robot_from_beam;
  if (beams.size() != 181 || beams.front().theta_rad != radians(-90.0) ||
      beams.back().theta_rad != radians(90.0)) {
    throw std::invalid_argument("FLASER: expected 181 beams from -90 to 90 degrees");
  }
}

std::string sonar_line(const RangeReading& reading, const RangeSensor& ring) {
  std::string line = "SONAR";
  append_numbers(line, {2.0 * ring.half_cone_rad});
  line += " " + std::to_string(reading.ranges_m.size());
  for (const float range_m : reading.ranges_m) append_range(line, range_m, ring.max_range_m);
  for (const Pose2& robot_from_beam : ring.robot_from_beam) append_pose(line, robot_from_beam);
  return line;
}

std::string flaser_line(const RangeReading& reading, const RangeSensor& laser) {
  std::string line = "FLASER " + std::to_string(reading.ranges_m.size());
  for (const float range_m : reading.ranges_m) append_range(line, range_m, laser.max_range_m);
  const Pose2& first = laser.robot_from_beam.front();
  append_pose(line, reading.odom_from_robot * Pose2{first.x_m, first.y_m, 0.0});
  append_pose(line, reading.odom_from_robot);
  return line;
}

}  // namespace

struct CarmenWriter::State {
  State(const Path& file, RangeSensor range_sensor)
      : output(file), sensor(std::move(range_sensor)) {}

  void write_line(std::string& line, double timestamp_s) {
    if (!start_s) start_s = timestamp_s;
    append_numbers(line, {timestamp_s});
    line += std::string(" ") + kHost;
    append_numbers(line, {timestamp_s - *start_s});
    output.write(line += '\n');
  }

  io::OutputFile output;
  RangeSensor sensor;
  std::optional<double> start_s;  ///< the logger's clock counts from here
};

CarmenWriter::CarmenWriter(const Path& file, const RangeSensor& sensor,
                           const RobotFootprint& footprint)
    : state_(std::make_unique<State>(file, sensor)) {
  require_front_laser(sensor);
  state_->output.write(
      "# CARMEN Logfile\n"
      "# file format is one message per line\n"
      "# message_name [message contents] ipc_timestamp ipc_hostname logger_timestamp\n"
      "# PARAM param_name param_value\n"
      "# ODOM x y theta tv rv accel\n"
      "# SONAR cone_angle num_sonars [range_readings] [offset_x offset_y offset_theta]\n"
      "# FLASER num_readings [range_readings] x y theta odom_x odom_y odom_theta\n"
      "# TRUEPOS true_x true_y true_theta odom_x odom_y odom_theta\n");
  state_->output.write(parameter_line("robot_length", footprint.length_m));
  state_->output.write(parameter_line("robot_width", footprint.width_m));
  const bool is_laser = sensor.kind == SensorKind::laser;
  state_->output.write(
      parameter_line(is_laser ? "robot_front_laser_max" : "robot_max_sonar", sensor.max_range_m));
}

CarmenWriter::~CarmenWriter() = default;

void CarmenWriter::write(const SimulatedStep& step) {
  const OdometryStep& odometry = step.odometry;
  const RangeSensor& sensor = state_->sensor;
  if (step.reading.ranges_m.size() != sensor.robot_from_beam.size()) {
    throw std::invalid_argument("a step has " + std::to_string(step.reading.ranges_m.size()) +
                                " ranges but the sensor has " +
                                std::to_string(sensor.robot_from_beam.size()) + " beams");
  }
  std::string line = "ODOM";
  append_pose(line, odometry.odom_from_robot);
  append_numbers(line, {odometry.speed_m_per_s, odometry.turn_rate_rad_per_s, 0.0});
  state_->write_line(line, odometry.timestamp_s);

  line = sensor.kind == SensorKind::laser ? flaser_line(step.reading, sensor)
                                          : sonar_line(step.reading, sensor);
  state_->write_line(line, step.reading.timestamp_s);

  line = "TRUEPOS";
  append_pose(line, step.truth.world_from_robot);
  append_pose(line, odometry.odom_from_robot);
  state_->write_line(line, step.truth.timestamp_s);
}

void CarmenWriter::finish() { state_->output.commit(); }

}  // namespace roomatlas
