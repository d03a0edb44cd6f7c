// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kSecondsPerHour = 3600.0;
constexpr int kPushTries = 8;  // for a direction in which there is room

double reach_of(const RobotFootprint& footprint) {
  return std::hypot(footprint.length_m, footprint.width_m) / 2.0;
}

Point2 half_size(const RobotFootprint& footprint) {
  return {footprint.length_m / 2.0, footprint.width_m / 2.0};
}

Pose2 after(const std::vector<Motion>& motions, Pose2 world_from_robot) {
  for (const Motion& motion : motions) {
    world_from_robot = world_from_robot * Pose2{motion.length_m, 0.0, motion.turn_rad};
  }
  return world_from_robot;
}

/// Whether a segment enters the rectangle around the origin (Liang and Barsky 1984).
bool enters(const Segment2& segment, const Point2& half_size) {
  const Point2 along = segment.b - segment.a;
  double from = 0.0;
  double to = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    if (along[axis] == 0.0) {
      if (std::abs(segment.a[axis]) >= half_size[axis]) return false;
      continue;
    }
    const double first = (-half_size[axis] - segment.a[axis]) / along[axis];
    const double second = (half_size[axis] - segment.a[axis]) / along[axis];
    from = std::max(from, std::min(first, second));
    to = std::min(to, std::max(first, second));
  }
  return from < to;
}

}  // namespace

Robot::Robot(const FloorPlan& world, const SimulationOptions& options,
             const Pose2& world_from_start)
    : options_(options),
      obstacles_(world),
      people_(world, options, world_from_start.position()),
      doors_(world, options),
      sensor_(std::make_shared<const RangeSensor>(range_sensor(options))),
      odometer_(options),
      reader_(options),
      pushes_(options.seed, "pushes"),
      world_from_robot_(world_from_start) {}

SimulatedStep Robot::start() { return sense({}); }

bool Robot::would_touch(const std::vector<Motion>& motions) const {
  const Pose2 end = after(motions, world_from_robot_);
  const Pose2 robot_from_world = inverse(end);
  const auto near = obstacles_.within(end.position(), reach_of(options_.footprint));
  return std::any_of(near.edges.begin(), near.edges.end(), [&](const Segment2& edge) {
    return enters(transformed(robot_from_world, edge), half_size(options_.footprint));
  });
}

SimulatedStep Robot::step(const std::vector<Motion>& motions) {
  OdometryStep odometry;
  odometer_.tick();
  for (const Motion& motion : motions) {
    const Odometer::Increment reported = odometer_.add(motion.length_m, motion.turn_rad);
    odometry.speed_m_per_s += reported.length_m * options_.rate_hz;
    odometry.turn_rate_rad_per_s += reported.turn_rad * options_.rate_hz;
  }
  world_from_robot_ = after(motions, world_from_robot_);
  people_.step(world_from_robot_.position());
  doors_.step(world_from_robot_.position());
  periods_ += 1.0;
  return sense(odometry);
}

bool Robot::is_clear(const Segment2& way) const {
  const double reach_m = reach_of(options_.footprint);
  const Obstacles near = obstacles_.within(way.a, (way.b - way.a).norm() + reach_m);
  return std::none_of(near.edges.begin(), near.edges.end(),
                      [&](const Segment2& edge) { return distance(way, edge) <= reach_m; });
}

bool Robot::is_pushed() {
  const OdometryFaults& faults = options_.faults;
  if (faults.pushes_per_hour <= 0.0) return false;
  const double each_period = faults.pushes_per_hour / (kSecondsPerHour * options_.rate_hz);
  if (pushes_.uniform() >= each_period) return false;
  for (int attempt = 0; attempt < kPushTries; ++attempt) {
    const double way_rad = 2.0 * kPi * pushes_.uniform();
    const Point2 to = world_from_robot_.position() +
                      faults.push_m * (0.5 + 0.5 * pushes_.uniform()) * direction(way_rad);
    const double turn_rad = radians(faults.push_deg) * (2.0 * pushes_.uniform() - 1.0);
    if (!is_clear({world_from_robot_.position(), to})) continue;
    world_from_robot_ = {to.x(), to.y(), wrap_angle(world_from_robot_.theta_rad + turn_rad)};
    return true;
  }
  return false;
}

/// Before the mission began odometry stood still.
Pose2 Robot::late_odometry() {
  const double periods = options_.faults.lag_s * options_.rate_hz;
  const auto whole = static_cast<std::size_t>(periods);
  odom_from_robot_.push_front(odometer_.odom_from_robot());
  if (odom_from_robot_.size() > whole + 2) odom_from_robot_.pop_back();
  const std::size_t last = odom_from_robot_.size() - 1;
  if (whole >= last) return odom_from_robot_[last];
  return interpolate(odom_from_robot_[whole], odom_from_robot_[whole + 1],
                     periods - static_cast<double>(whole));
}

SimulatedStep Robot::sense(OdometryStep odometry) {
  odometry.timestamp_s = options_.start_timestamp_s + periods_ / options_.rate_hz;
  odometry.odom_from_robot =
      options_.faults.lag_s > 0.0 ? late_odometry() : odometer_.odom_from_robot();
  auto near = obstacles_.within(world_from_robot_.position(),
                                sensor_->max_range_m + reach_of(options_.footprint));
  for (const std::vector<Segment2>& moving : {people_.edges(), doors_.edges()}) {
    near.edges.insert(near.edges.end(), moving.begin(), moving.end());
  }
  SimulatedStep step;
  step.odometry = odometry;
  step.reading = {odometry.timestamp_s, odometry.odom_from_robot, sensor_,
                  reader_.read(near, world_from_robot_, *sensor_)};
  step.truth = {odometry.timestamp_s, world_from_robot_};
  step.people = people_.places();
  return step;
}

}  // namespace roomatlas
