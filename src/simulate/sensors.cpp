// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/simulate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace roomatlas {
namespace {

struct Sonar {
  double forward_m;
  double left_m;
  double bearing_deg;
};

/// The front left quarter of the Pioneer 2's arrays, clockwise. The rest are mirror images.
constexpr std::array<Sonar, 4> kFrontLeft = {{
    {0.115, 0.130, 90.0},
    {0.155, 0.115, 50.0},
    {0.190, 0.080, 30.0},
    {0.210, 0.025, 10.0},
}};
constexpr double kRealHalfLength_m = 0.210;  // of the outermost of these
constexpr double kRealHalfWidth_m = 0.130;   // likewise

constexpr double kLaserForwardM = 0.1;  // ahead of the robot's middle
constexpr int kFrontSonars = 8;
constexpr int kAllSonars = 16;

/// A sonar on an ellipse that just holds the footprint's sides.
Pose2 on_rim(double bearing_deg, const RobotFootprint& footprint) {
  const double bearing_rad = wrap_angle(radians(bearing_deg));
  return {footprint.length_m / 2.0 * std::cos(bearing_rad),
          footprint.width_m / 2.0 * std::sin(bearing_rad), bearing_rad};
}

/// Degrees from one beam to the next: around the whole circle the last is not the first again.
double step_deg(const SimulationOptions& options) {
  const int gaps = options.laser_view_deg >= 360.0 ? options.laser_beams : options.laser_beams - 1;
  return options.laser_view_deg / gaps;
}

}  // namespace

RangeSensor pioneer_sonar_ring(const SimulationOptions& options) {
  RangeSensor ring;
  ring.kind = SensorKind::sonar;
  ring.half_cone_rad = radians(options.sonar_cone_deg / 2.0);
  ring.max_range_m = options.sonar_max_range_m;

  // The real places are stretched to the footprint, so that the outermost stand on its rim.
  const double stretch_x = options.footprint.length_m / 2.0 / kRealHalfLength_m;
  const double stretch_y = options.footprint.width_m / 2.0 / kRealHalfWidth_m;
  const auto add = [&](const Sonar& sonar, bool behind, bool right) {
    const double bearing_deg = behind ? 180.0 - sonar.bearing_deg : sonar.bearing_deg;
    const double x_m = sonar.forward_m * stretch_x;
    const double y_m = sonar.left_m * stretch_y;
    ring.robot_from_beam.push_back({behind ? -x_m : x_m, right ? -y_m : y_m,
                                    wrap_angle(radians(right ? -bearing_deg : bearing_deg))});
  };
  for (auto sonar = kFrontLeft.begin(); sonar != kFrontLeft.end(); ++sonar)
    add(*sonar, false, false);
  for (auto sonar = kFrontLeft.rbegin(); sonar != kFrontLeft.rend(); ++sonar)
    add(*sonar, false, true);
  for (auto sonar = kFrontLeft.begin(); sonar != kFrontLeft.end(); ++sonar) add(*sonar, true, true);
  for (auto sonar = kFrontLeft.rbegin(); sonar != kFrontLeft.rend(); ++sonar)
    add(*sonar, true, false);
  return ring;
}

RangeSensor sonar_ring(const SimulationOptions& options) {
  RangeSensor ring = pioneer_sonar_ring(options);
  if (options.sonars == kAllSonars) return ring;
  std::vector<Pose2>& beams = ring.robot_from_beam;
  if (options.sonars <= kFrontSonars) {
    beams.clear();
    for (int i = 0; i < options.sonars; ++i) {
      beams.push_back(on_rim(90.0 - 180.0 * i / (options.sonars - 1), options.footprint));
    }
    return ring;
  }
  beams.resize(kFrontSonars);
  const int behind = options.sonars - kFrontSonars;
  for (int i = 1; i <= behind; ++i) {
    beams.push_back(on_rim(-90.0 - 180.0 * i / (behind + 1), options.footprint));
  }
  return ring;
}

RangeSensor front_laser(const SimulationOptions& options) {
  RangeSensor laser;
  laser.kind = SensorKind::laser;
  laser.max_range_m = options.laser_max_range_m;
  for (int side = 0; side < (options.laser_behind ? 2 : 1); ++side) {
    const double x_m = side == 0 ? kLaserForwardM : -kLaserForwardM;
    for (int i = 0; i < options.laser_beams; ++i) {
      const double bearing_deg = -options.laser_view_deg / 2.0 + i * step_deg(options);
      const double theta_rad = side == 0 ? radians(bearing_deg) : radians(bearing_deg) + kPi;
      const bool is_wrapped = std::abs(theta_rad) < kPi;
      laser.robot_from_beam.push_back({x_m, 0.0, is_wrapped ? theta_rad : wrap_angle(theta_rad)});
    }
  }
  return laser;
}

RangeSensor range_sensor(const SimulationOptions& options) {
  return options.sensor == SensorKind::laser ? front_laser(options) : sonar_ring(options);
}

}  // namespace roomatlas
