// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas::test {

using WallLine = std::pair<Point2, Point2>;

/// Walls along a closed or open line of corners.
inline std::vector<WallLine> walls_along(const std::vector<Point2>& corners, bool closed) {
  std::vector<WallLine> walls;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    walls.emplace_back(corners[i], corners[i + 1]);
  }
  if (closed) walls.emplace_back(corners.back(), corners.front());
  return walls;
}

/// The front half of a Pioneer's ring, at the robot's middle.
inline std::shared_ptr<const RangeSensor> front_ring() {
  RangeSensor sensor;
  sensor.kind = SensorKind::sonar;
  sensor.half_cone_rad = radians(10.0);
  sensor.max_range_m = 5.0;
  for (const double deg : {90.0, 50.0, 30.0, 10.0, -10.0, -30.0, -50.0, -90.0}) {
    sensor.robot_from_beam.push_back({0.0, 0.0, radians(deg)});
  }
  return std::make_shared<const RangeSensor>(sensor);
}

/// Distance along a ray to a wall; infinity where it misses.
inline double ray_to_wall(const Point2& from, const Point2& along, const WallLine& wall) {
  const Point2 edge = wall.second - wall.first;
  const Point2 to = wall.first - from;
  const double across = along.x() * edge.y() - along.y() * edge.x();
  const double at = (to.x() * edge.y() - to.y() * edge.x()) / across;
  const double share = (to.x() * along.y() - to.y() * along.x()) / across;
  const bool hit = at > 0.0 && share >= 0.0 && share <= 1.0;  // parallel: a NaN, which is no hit
  return hit ? at : std::numeric_limits<double>::infinity();
}

/// The least range over many rays of a cone.
inline double cone_range(const std::vector<WallLine>& walls, const Pose2& map_from_beam,
                         double half_cone_rad) {
  constexpr int kRays = 40;
  double least = std::numeric_limits<double>::infinity();
  for (int ray = -kRays; ray <= kRays; ++ray) {
    const Point2 along = direction(map_from_beam.theta_rad + half_cone_rad * ray / kRays);
    for (const WallLine& wall : walls) {
      least = std::min(least, ray_to_wall(map_from_beam.position(), along, wall));
    }
  }
  return least;
}

/// Drives straight from point to point and turns on the spot.
inline std::vector<Pose2> drive_along(const std::vector<Point2>& points, double step_m = 0.08,
                                      double turn_rad = 0.12) {
  std::vector<Pose2> poses;
  Pose2 pose;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point2 leg = points[i + 1] - points[i];
    const double heading = std::atan2(leg.y(), leg.x());
    if (i == 0) pose = {points[0].x(), points[0].y(), heading};
    const double turn = wrap_angle(heading - pose.theta_rad);
    const int turns = static_cast<int>(std::ceil(std::abs(turn) / turn_rad));
    const double start = pose.theta_rad;
    for (int k = 1; k <= turns; ++k) {
      pose.theta_rad = wrap_angle(start + turn * k / turns);
      poses.push_back(pose);
    }
    const int steps = static_cast<int>(std::ceil(leg.norm() / step_m));
    for (int k = 1; k <= steps; ++k) {
      const Point2 at = points[i] + leg * k / steps;
      pose = {at.x(), at.y(), heading};
      poses.push_back(pose);
    }
  }
  return poses;
}

/// A laser that sees half a circle before the robot, from its middle.
inline std::shared_ptr<const RangeSensor> laser_of(int beams) {
  RangeSensor sensor{SensorKind::laser, {}, 0.0, 5.0};
  for (int i = 0; i < beams; ++i) {
    sensor.robot_from_beam.push_back({0.0, 0.0, radians(180.0 * i / (beams - 1) - 90.0)});
  }
  return std::make_shared<const RangeSensor>(sensor);
}

/// Readings along true poses, with odometry whose heading drifts over the way.
inline std::vector<RangeReading> readings_along(
    const std::vector<WallLine>& walls, const std::vector<Pose2>& truth, double drift_deg_per_m,
    const std::shared_ptr<const RangeSensor>& sensor = front_ring()) {
  std::vector<RangeReading> readings;
  Pose2 odometry = truth.front();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (i > 0) {
      Pose2 step = inverse(truth[i - 1]) * truth[i];
      step.theta_rad += radians(drift_deg_per_m) * step.position().norm();
      odometry = odometry * step;
    }
    RangeReading reading{0.2 * static_cast<double>(i), odometry, sensor, {}};
    for (const Pose2& beam : sensor->robot_from_beam) {
      const double range = cone_range(walls, truth[i] * beam, sensor->half_cone_rad);
      reading.ranges_m.push_back(static_cast<float>(std::min(range, sensor->max_range_m)));
    }
    readings.push_back(reading);
  }
  return readings;
}

/// A mission whose truth is known.
struct DrivenWorld {
  std::vector<Pose2> truth;
  std::vector<RangeReading> readings;
};

inline DrivenWorld drive(const std::vector<WallLine>& walls, const std::vector<Point2>& points,
                         double drift_deg_per_m,
                         const std::shared_ptr<const RangeSensor>& sensor = front_ring()) {
  DrivenWorld mission;
  mission.truth = drive_along(points);
  mission.readings = readings_along(walls, mission.truth, drift_deg_per_m, sensor);
  return mission;
}

/// A corridor that goes on at another angle: twice there and back.
inline DrivenWorld bent_corridor(double angle_deg) {
  const Point2 along = direction(radians(angle_deg));
  const Point2 left(-along.y(), along.x());
  const Point2 bend(9.0, 0.0);
  const double shift = 0.9 * std::tan(radians(angle_deg) / 2.0);
  const Point2 outer = bend + Point2(shift, -0.9);
  const Point2 inner = bend + Point2(-shift, 0.9);
  const auto walls = walls_along({{-1.0, -0.9},
                                  outer,
                                  bend + 10.0 * along - 0.9 * left,
                                  bend + 10.0 * along + 0.9 * left,
                                  inner,
                                  {-1.0, 0.9}},
                                 true);
  const Point2 end = bend + 9.0 * along;
  return drive(walls, {{0, 0}, bend, end, bend, {0, 0}, bend, end, bend, {0, 0}}, 0.1);
}

inline std::vector<double> path_lengths(const std::vector<Pose2>& poses) {
  std::vector<double> path_m = {0.0};
  for (std::size_t i = 1; i < poses.size(); ++i) {
    path_m.push_back(path_m.back() + (poses[i].position() - poses[i - 1].position()).norm());
  }
  return path_m;
}

}  // namespace roomatlas::test
