// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot.hpp"

#include <cmath>
#include <string>

namespace roomatlas {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw UsageError("simulation: expected " + what);
}

bool positive(double value) { return std::isfinite(value) && value > 0.0; }

/// False for a NaN too.
bool within(double value, double low, double high) { return value >= low && value <= high; }

}  // namespace

void require_sound(const SimulationOptions& options) {
  require(positive(options.speed_m_per_s), "speed_m_per_s > 0");
  require(positive(options.turn_rate_deg_per_s), "turn_rate_deg_per_s > 0");
  require(positive(options.rate_hz), "rate_hz > 0");
  require(std::isfinite(options.start_timestamp_s), "a finite start_timestamp_s");
  require(positive(options.sonar_max_range_m), "sonar_max_range_m > 0");
  require(positive(options.laser_max_range_m), "laser_max_range_m > 0");
  require(within(options.sonar_cone_deg, 0.0, 179.0), "sonar_cone_deg in [0, 179]");
  require(options.sonars >= 3 && options.sonars <= 16, "sonars in [3, 16]");
  require(options.laser_view_deg > 0.0 && options.laser_view_deg <= 360.0,
          "laser_view_deg in (0, 360]");
  require(options.laser_beams >= 2 && options.laser_beams <= 10000, "laser_beams in [2, 10000]");
  require(options.people >= 0 && options.people <= 1000, "people in [0, 1000]");
  require(within(options.moving_doors_share, 0.0, 1.0), "moving_doors_share in [0, 1]");
  require(positive(options.footprint.length_m), "footprint.length_m > 0");
  require(positive(options.footprint.width_m), "footprint.width_m > 0");

  const OdometryErrors& odometry = options.odometry;
  require(within(odometry.length_share, -0.5, 0.5), "length_share in [-0.5, 0.5]");
  require(within(odometry.heading_bias_deg_per_m, -90.0, 90.0),
          "heading_bias_deg_per_m in [-90, 90]");
  require(within(odometry.heading_noise_deg_per_sqrt_m, 0.0, 90.0),
          "heading_noise_deg_per_sqrt_m in [0, 90]");
  require(within(odometry.turn_share, -0.5, 0.5), "turn_share in [-0.5, 0.5]");

  const OdometryFaults& faults = options.faults;
  require(within(faults.slip_share, 0.0, 1.0), "slip_share in [0, 1]");
  require(within(faults.lag_s, 0.0, 10.0), "lag_s in [0, 10]");
  require(within(faults.pushes_per_hour, 0.0, 3600.0), "pushes_per_hour in [0, 3600]");
  require(within(faults.push_m, 0.0, 10.0), "push_m in [0, 10]");
  require(within(faults.push_deg, 0.0, 180.0), "push_deg in [0, 180]");
  require(within(faults.dropouts_per_hour, 0.0, 3600.0), "dropouts_per_hour in [0, 3600]");
  require(within(faults.dropout_s, 0.0, 60.0), "dropout_s in [0, 60]");

  const SonarErrors& sonar = options.sonar;
  require(within(sonar.range_noise_m, 0.0, 10.0), "range_noise_m in [0, 10]");
  require(within(sonar.dropout_share, 0.0, 1.0), "dropout_share in [0, 1]");
  require(within(sonar.specular_limit_deg, 0.0, 90.0), "specular_limit_deg in [0, 90]");
  require(within(sonar.crosstalk_share, 0.0, 1.0), "crosstalk_share in [0, 1]");
  require(within(sonar.corner_echo_m, 0.0, 100.0), "corner_echo_m in [0, 100]");
  require(within(options.laser.range_noise_m, 0.0, 10.0), "laser range_noise_m in [0, 10]");
  require(within(options.laser.dropout_share, 0.0, 1.0), "laser dropout_share in [0, 1]");
  require(within(options.laser.silent_share, 0.0, 1.0), "laser silent_share in [0, 1]");
}

}  // namespace roomatlas
