// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/simulate.hpp"

#include <array>

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

RangeSensor front_laser(const SimulationOptions& options) {
  RangeSensor laser;
  laser.kind = SensorKind::laser;
  laser.max_range_m = options.laser_max_range_m;
  for (int bearing_deg = -90; bearing_deg <= 90; ++bearing_deg) {
    laser.robot_from_beam.push_back({kLaserForwardM, 0.0, radians(bearing_deg)});
  }
  return laser;
}

RangeSensor range_sensor(const SimulationOptions& options) {
  return options.sensor == SensorKind::laser ? front_laser(options) : pioneer_sonar_ring(options);
}

}  // namespace roomatlas
