// SPDX-License-Identifier: GPL-3.0-or-later
#include "numbers.hpp"
#include "output_file.hpp"

#include "roomatlas/io/formats.hpp"

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

}  // namespace

struct CarmenWriter::State {
  State(const Path& file, RangeSensor sonar_ring) : output(file), ring(std::move(sonar_ring)) {}

  void write_line(std::string& line, double timestamp_s) {
    if (!start_s) start_s = timestamp_s;
    append_numbers(line, {timestamp_s});
    line += std::string(" ") + kHost;
    append_numbers(line, {timestamp_s - *start_s});
    output.write(line += '\n');
  }

  io::OutputFile output;
  RangeSensor ring;
  std::optional<double> start_s;  ///< the logger's clock counts from here
};

CarmenWriter::CarmenWriter(const Path& file, const RangeSensor& ring,
                           const RobotFootprint& footprint)
    : state_(std::make_unique<State>(file, ring)) {
  state_->output.write(
      "# CARMEN Logfile\n"
      "# file format is one message per line\n"
      "# message_name [message contents] ipc_timestamp ipc_hostname logger_timestamp\n"
      "# PARAM param_name param_value\n"
      "# ODOM x y theta tv rv accel\n"
      "# SONAR cone_angle num_sonars [range_readings] [offset_x offset_y offset_theta]\n"
      "# TRUEPOS true_x true_y true_theta odom_x odom_y odom_theta\n");
  state_->output.write(parameter_line("robot_length", footprint.length_m));
  state_->output.write(parameter_line("robot_width", footprint.width_m));
  state_->output.write(parameter_line("robot_max_sonar", ring.max_range_m));
}

CarmenWriter::~CarmenWriter() = default;

void CarmenWriter::write(const SimulatedStep& step) {
  const OdometryStep& odometry = step.odometry;
  const std::vector<float>& ranges_m = step.sonar.ranges_m;
  const std::vector<Pose2>& mounting = state_->ring.robot_from_beam;
  if (ranges_m.size() != mounting.size()) {
    throw std::invalid_argument("a step has " + std::to_string(ranges_m.size()) +
                                " ranges but the ring has " + std::to_string(mounting.size()) +
                                " sonars");
  }
  std::string line = "ODOM";
  append_pose(line, odometry.odom_from_robot);
  append_numbers(line, {odometry.speed_m_per_s, odometry.turn_rate_rad_per_s, 0.0});
  state_->write_line(line, odometry.timestamp_s);

  line = "SONAR";
  append_numbers(line, {2.0 * state_->ring.half_cone_rad});
  line += " " + std::to_string(ranges_m.size());
  for (const float range_m : ranges_m) append_range(line, range_m, state_->ring.max_range_m);
  for (const Pose2& robot_from_beam : mounting) append_pose(line, robot_from_beam);
  state_->write_line(line, step.sonar.timestamp_s);

  line = "TRUEPOS";
  append_pose(line, step.truth.world_from_robot);
  append_pose(line, odometry.odom_from_robot);
  state_->write_line(line, step.truth.timestamp_s);
}

void CarmenWriter::finish() { state_->output.commit(); }

}  // namespace roomatlas
