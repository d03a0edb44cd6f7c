// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/output_file.hpp"
#include "logs/beam_fan.hpp"
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
bool is_front_laser(const RangeSensor& sensor) {
  const std::vector<Pose2>& beams = sensor.robot_from_beam;
  return sensor.kind == SensorKind::laser && beams.size() == 181 &&
         beams.front().theta_rad == radians(-90.0) && beams.back().theta_rad == radians(90.0);
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

/// Type and accuracy are not known; nothing is of remission, motion or the turn's axis.
std::string robot_laser_line(const RangeReading& reading, const RangeSensor& laser) {
  const io::BeamFan fan = io::fan_of(laser).value();
  const std::size_t beams = reading.ranges_m.size();
  std::string line = "ROBOTLASER1 0";
  append_numbers(line, {fan.first_rad, fan.step_rad * static_cast<double>(beams - 1), fan.step_rad,
                        laser.max_range_m, 0.0, 0.0});
  line += " " + std::to_string(beams);
  for (const float range_m : reading.ranges_m) append_range(line, range_m, laser.max_range_m);
  line += " 0";  // remissions
  append_pose(line, reading.odom_from_robot * Pose2{fan.origin.x(), fan.origin.y(), 0.0});
  append_pose(line, reading.odom_from_robot);
  return line + " 0 0 0 0 0";
}

}  // namespace

struct CarmenWriter::State {
  explicit State(const Path& file) : output(file) {}

  void write_line(std::string& line, double timestamp_s) {
    if (!start_s) start_s = timestamp_s;
    append_numbers(line, {timestamp_s});
    line += std::string(" ") + kHost;
    append_numbers(line, {timestamp_s - *start_s});
    output.write(line += '\n');
  }

  io::OutputFile output;
  Pose2 odom_from_robot;          ///< the latest
  std::optional<double> start_s;  ///< the logger's clock counts from here
};

CarmenWriter::CarmenWriter(const Path& file, const RangeSensor& sensor,
                           const RobotFootprint& footprint)
    : state_(std::make_unique<State>(file)) {
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
  if (sensor.kind == SensorKind::sonar) {
    state_->output.write(parameter_line("robot_max_sonar", sensor.max_range_m));
  } else if (is_front_laser(sensor)) {  // lines of others tell it
    state_->output.write(parameter_line("robot_front_laser_max", sensor.max_range_m));
  }
}

CarmenWriter::~CarmenWriter() = default;

void CarmenWriter::write(const OdometryStep& odometry) {
  std::string line = "ODOM";
  append_pose(line, odometry.odom_from_robot);
  append_numbers(line, {odometry.speed_m_per_s, odometry.turn_rate_rad_per_s, 0.0});
  state_->write_line(line, odometry.timestamp_s);
  state_->odom_from_robot = odometry.odom_from_robot;
}

void CarmenWriter::write(const RangeReading& reading) {
  io::require_a_range_a_beam(reading);
  if (reading.sensor->kind == SensorKind::sonar) {
    std::string line = sonar_line(reading, *reading.sensor);
    return state_->write_line(line, reading.timestamp_s);
  }
  for (const RangeReading& fan : io::fans_in(reading)) {
    std::string line = is_front_laser(*fan.sensor) ? flaser_line(fan, *fan.sensor)
                                                   : robot_laser_line(fan, *fan.sensor);
    state_->write_line(line, reading.timestamp_s);
  }
}

void CarmenWriter::write(const TruePose& truth) {
  std::string line = "TRUEPOS";
  append_pose(line, truth.world_from_robot);
  append_pose(line, state_->odom_from_robot);
  state_->write_line(line, truth.timestamp_s);
}

void CarmenWriter::finish() { state_->output.commit(); }

}  // namespace roomatlas
