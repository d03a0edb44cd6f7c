// SPDX-License-Identifier: GPL-3.0-or-later
#include "sensor_catalog.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::io {
namespace {

constexpr double kSamePosition_m = 1e-3;  // a log's last digit; larger joins two sensors
constexpr double kSameAngle_rad = 1e-4;   // likewise
constexpr double kRounding = 1e-9;        // two values one step apart count as the same

bool same_angle(double a_rad, double b_rad) {
  return std::abs(wrap_angle(a_rad - b_rad)) <= kSameAngle_rad + kRounding;
}

bool same_pose(const Pose2& a, const Pose2& b) {
  return (a.position() - b.position()).norm() <= kSamePosition_m + kRounding &&
         same_angle(a.theta_rad, b.theta_rad);
}

bool same_sensor(const RangeSensor& a, const RangeSensor& b) {
  return a.kind == b.kind && a.robot_from_beam.size() == b.robot_from_beam.size() &&
         std::abs(a.max_range_m - b.max_range_m) <= kSamePosition_m &&
         std::abs(a.half_cone_rad - b.half_cone_rad) <= kSameAngle_rad &&
         std::equal(a.robot_from_beam.begin(), a.robot_from_beam.end(), b.robot_from_beam.begin(),
                    same_pose);
}

double rounded(double value, double step) { return std::round(value / step) * step + 0.0; }

double rounded_angle(double angle_rad) {
  const double quarter = rounded(angle_rad, kPi / 2);
  return wrap_angle(same_angle(angle_rad, quarter) ? quarter : rounded(angle_rad, kSameAngle_rad));
}

/// The limit as a float would hold it, so that a range printed as the limit is at the limit.
double smallest_limit(double option_m, const std::optional<double>& parameter_m, double line_m) {
  double limit = parameter_m ? std::min(option_m, *parameter_m) : option_m;
  if (line_m > 0.0) limit = std::min(limit, line_m);
  return static_cast<double>(static_cast<float>(limit));
}

}  // namespace

Pose2 robot_from_laser(const CarmenTag& tag, const CarmenScan& scan,
                       const CarmenParameters& parameters, bool poses_hold) {
  const bool rear = tag.place == LaserPlace::rear;
  Pose2 usual;
  if (tag.place == LaserPlace::front) usual.x_m = parameters.front_laser_offset_m.value_or(0.0);
  if (rear) usual = {parameters.rear_laser_offset_m.value_or(0.0), 0.0, -kPi};
  if (!poses_hold) return usual;
  const Pose2 exact = inverse(scan.odom_from_robot) * scan.odom_from_laser;
  const Pose2 told = {rounded(exact.x_m, kSamePosition_m), rounded(exact.y_m, kSamePosition_m),
                      rounded_angle(exact.theta_rad)};
  if (rear && told == Pose2{}) return usual;
  if (rear && told.theta_rad == 0.0) return {told.x_m, told.y_m, -kPi};
  return told;
}

double half_cone_rad(double cone_on_line, const MissionOptions& options) {
  double cone_rad = radians(options.sonar_cone_deg);
  if (cone_on_line > 0.0 && cone_on_line < kPi) cone_rad = cone_on_line;
  if (cone_on_line >= kPi && cone_on_line < 180.0) cone_rad = radians(cone_on_line);
  return cone_rad / 2;
}

void SensorCatalog::describe_laser(const CarmenTag& tag, const CarmenScan& scan,
                                   const CarmenParameters& parameters, bool poses_hold) {
  const Pose2 mounting = robot_from_laser(tag, scan, parameters, poses_hold);
  wanted_.kind = SensorKind::laser;
  wanted_.half_cone_rad = 0.0;
  const auto& parameter_m = tag.place == LaserPlace::front  ? parameters.front_laser_max_range_m
                            : tag.place == LaserPlace::rear ? parameters.rear_laser_max_range_m
                                                            : std::nullopt;
  wanted_.max_range_m = smallest_limit(options_.laser_max_range_m, parameter_m, scan.max_range_m);
  wanted_.robot_from_beam.clear();
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const double angle_rad = scan.start_rad + static_cast<double>(i) * scan.step_rad;
    wanted_.robot_from_beam.push_back(
        {mounting.x_m, mounting.y_m, wrap_angle(mounting.theta_rad + angle_rad)});
  }
}

void SensorCatalog::describe_sonar(const CarmenScan& scan, const CarmenParameters& parameters) {
  wanted_.kind = SensorKind::sonar;
  wanted_.half_cone_rad = half_cone_rad(scan.cone_rad, options_);
  wanted_.max_range_m =
      smallest_limit(options_.sonar_max_range_m, parameters.sonar_max_range_m, 0.0);
  wanted_.robot_from_beam.assign(scan.robot_from_sonar.begin(), scan.robot_from_sonar.end());
}

std::shared_ptr<const RangeSensor> SensorCatalog::sensor_of(const CarmenTag& tag,
                                                            const CarmenScan& scan,
                                                            const CarmenParameters& parameters,
                                                            bool poses_hold) {
  if (tag.kind == CarmenKind::sonar) {
    describe_sonar(scan, parameters);
  } else {
    describe_laser(tag, scan, parameters, poses_hold);
  }
  const auto found = std::find_if(sensors_.begin(), sensors_.end(), [this](const auto& known) {
    return same_sensor(*known, wanted_);
  });
  if (found != sensors_.end()) return *found;
  if (sensors_.size() >= kMostSensors) sensors_.erase(sensors_.begin());
  return sensors_.emplace_back(std::make_shared<const RangeSensor>(wanted_));
}

}  // namespace roomatlas::io
