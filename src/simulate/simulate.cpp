// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/simulate.hpp"

#include "obstacles.hpp"
#include "odometer.hpp"
#include "route.hpp"
#include "sonar.hpp"

#include <cmath>
#include <memory>
#include <string>

namespace roomatlas {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw UsageError("simulation: expected " + what);
}

bool positive(double value) { return std::isfinite(value) && value > 0.0; }

/// False for a NaN too.
bool within(double value, double low, double high) { return value >= low && value <= high; }

void require_sound(const SimulationOptions& options) {
  require(positive(options.speed_m_per_s), "speed_m_per_s > 0");
  require(positive(options.turn_rate_deg_per_s), "turn_rate_deg_per_s > 0");
  require(positive(options.rate_hz), "rate_hz > 0");
  require(std::isfinite(options.start_timestamp_s), "a finite start_timestamp_s");
  require(positive(options.sonar_max_range_m), "sonar_max_range_m > 0");
  require(within(options.sonar_cone_deg, 0.0, 179.0), "sonar_cone_deg in [0, 179]");
  require(positive(options.footprint.length_m), "footprint.length_m > 0");
  require(positive(options.footprint.width_m), "footprint.width_m > 0");

  const OdometryErrors& odometry = options.odometry;
  require(within(odometry.length_share, -0.5, 0.5), "length_share in [-0.5, 0.5]");
  require(within(odometry.heading_bias_deg_per_m, -90.0, 90.0),
          "heading_bias_deg_per_m in [-90, 90]");
  require(within(odometry.heading_noise_deg_per_sqrt_m, 0.0, 90.0),
          "heading_noise_deg_per_sqrt_m in [0, 90]");

  const SonarErrors& sonar = options.sonar;
  require(within(sonar.range_noise_m, 0.0, 10.0), "range_noise_m in [0, 10]");
  require(within(sonar.dropout_share, 0.0, 1.0), "dropout_share in [0, 1]");
  require(within(sonar.specular_limit_deg, 0.0, 90.0), "specular_limit_deg in [0, 90]");
}

/// What odometry reports `time_s` after the start, one period after the step before.
OdometryStep odometry_step(Odometer& odometer, const Route& route, double time_s, double period_s) {
  OdometryStep step;
  for (const Motion& motion : motions_between(route, time_s - period_s, time_s)) {
    const Odometer::Increment reported = odometer.add(motion.length_m, motion.turn_rad);
    step.speed_m_per_s += reported.length_m / period_s;
    step.turn_rate_rad_per_s += reported.turn_rad / period_s;
  }
  step.odom_from_robot = odometer.odom_from_robot();
  return step;
}

}  // namespace

void simulate(const FloorPlan& world, const Drive& drive, const SimulationOptions& options,
              const std::function<void(const SimulatedStep&)>& sink) {
  require_sound(options);
  const std::vector<Leg> legs = legs_of(drive);
  require_clear(world, legs, options.footprint.width_m / 2.0);
  const Route route = route_along(legs, options);
  const std::vector<Segment2> edges = obstacle_edges(world);
  const auto ring = std::make_shared<const RangeSensor>(pioneer_sonar_ring(options));
  const double reach_m =
      ring->max_range_m + std::hypot(options.footprint.length_m, options.footprint.width_m) / 2.0;
  Odometer odometer(options.odometry, options.seed);
  SonarReader sonar(options.sonar, options.seed);

  const double last = std::ceil(duration_s(route) * options.rate_hz - 1e-9);
  for (double number = 0.0; number <= last; number += 1.0) {
    const double time_s = number / options.rate_hz;
    const double timestamp_s = options.start_timestamp_s + time_s;
    const Pose2 world_from_robot = world_from_robot_at(route, time_s);
    const auto near = edges_within(edges, world_from_robot.position(), reach_m);

    SimulatedStep step;
    step.odometry = odometry_step(odometer, route, time_s, 1.0 / options.rate_hz);
    step.odometry.timestamp_s = timestamp_s;
    step.sonar = {timestamp_s, step.odometry.odom_from_robot, ring,
                  sonar.read(near, world_from_robot, *ring)};
    step.truth = {timestamp_s, world_from_robot};
    sink(step);
  }
}

}  // namespace roomatlas
