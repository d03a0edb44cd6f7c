// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds as one reads them, and a laser robot that drives through them. The ray casting is brute
// force over the drawing's edges: nothing of the library but its geometry.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas::test {

/// '#' is wall, anything else is free; a, b, c ... are way-points, visited in that order. The
/// first line is the northernmost; each letter is a square of `kLetterM`, the lower left corner of
/// the drawing is the origin.
using WorldDrawing = std::vector<std::string>;

constexpr double kLetterM = 0.3;

inline bool is_wall(const WorldDrawing& drawing, int column, int row) {
  if (row < 0 || row >= static_cast<int>(drawing.size()) || column < 0) return false;
  const std::string& line = drawing[drawing.size() - 1 - static_cast<std::size_t>(row)];
  return static_cast<std::size_t>(column) < line.size() &&
         line[static_cast<std::size_t>(column)] == '#';
}

inline int columns_of(const WorldDrawing& drawing) {
  std::size_t columns = 0;
  for (const std::string& line : drawing) columns = std::max(columns, line.size());
  return static_cast<int>(columns);
}

/// The surfaces of the walls, each straight stretch once.
inline std::vector<Segment2> surfaces_of(const WorldDrawing& drawing) {
  const int columns = columns_of(drawing);
  const int rows = static_cast<int>(drawing.size());
  std::vector<Segment2> surfaces;
  /// Stretches along one lattice line, where what is on its two sides differs.
  const auto add_line = [&](int length, auto differs, auto point) {
    for (int from = 0, to = 0; from < length; from = to + 1) {
      for (to = from; to < length && differs(to);) ++to;
      if (to > from) surfaces.push_back({kLetterM * point(from), kLetterM * point(to)});
    }
  };
  for (int y = 0; y <= rows; ++y) {
    add_line(
        columns, [&](int x) { return is_wall(drawing, x, y - 1) != is_wall(drawing, x, y); },
        [&](int x) { return Point2(x, y); });
  }
  for (int x = 0; x <= columns; ++x) {
    add_line(
        rows, [&](int y) { return is_wall(drawing, x - 1, y) != is_wall(drawing, x, y); },
        [&](int y) { return Point2(x, y); });
  }
  return surfaces;
}

/// The walls as bodies, one for each row's stretch: a world for the simulator.
inline FloorPlan plan_of(const WorldDrawing& drawing) {
  FloorPlan plan;
  for (int y = 0; y < static_cast<int>(drawing.size()); ++y) {
    for (int from = 0, to = 0; from < columns_of(drawing); from = to + 1) {
      for (to = from; is_wall(drawing, to, y);) ++to;
      if (to == from) continue;
      const Point2 low(from * kLetterM, y * kLetterM);
      const Point2 high(to * kLetterM, (y + 1) * kLetterM);
      plan.walls.push_back(
          {{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, std::vector<Ring>{}});
    }
  }
  return plan;
}

inline Polyline way_points_of(const WorldDrawing& drawing) {
  std::map<char, Point2> found;
  for (std::size_t line = 0; line < drawing.size(); ++line) {
    for (std::size_t column = 0; column < drawing[line].size(); ++column) {
      const char letter = drawing[line][column];
      if (letter < 'a' || letter > 'z') continue;
      const auto row = static_cast<double>(drawing.size() - 1 - line);
      found[letter] = kLetterM * Point2(static_cast<double>(column) + 0.5, row + 0.5);
    }
  }
  Polyline points;
  for (const auto& entry : found) points.push_back(entry.second);
  return points;
}

struct LaserRobot {
  int beams = 180;  ///< all around
  double max_range_m = 20.0;
  double noise_m = 0.0;
  double step_m = 0.05;
  double turn_deg = 5.0;
  Pose2 odom_from_world;  ///< where odometry's frame is
  double start_s = 100.0;
};

inline std::shared_ptr<const RangeSensor> sensor_of(const LaserRobot& robot) {
  auto sensor = std::make_shared<RangeSensor>();
  sensor->max_range_m = robot.max_range_m;
  for (int i = 0; i < robot.beams; ++i) {
    sensor->robot_from_beam.push_back({0.0, 0.0, wrap_angle(2.0 * kPi * i / robot.beams)});
  }
  return sensor;
}

/// Poses along way-points: straight legs and turns on the spot.
inline std::vector<Pose2> poses_along(const Polyline& points, const LaserRobot& robot) {
  if (points.size() < 2) throw std::invalid_argument("a drive needs two way-points");
  std::vector<Pose2> poses;
  for (std::size_t leg = 1; leg < points.size(); ++leg) {
    const Point2 along = points[leg] - points[leg - 1];
    const double heading = std::atan2(along.y(), along.x());
    const double before = poses.empty() ? heading : poses.back().theta_rad;
    const double turn = wrap_angle(heading - before);
    const int turns = static_cast<int>(std::ceil(std::abs(turn) / radians(robot.turn_deg)));
    for (int i = 1; i <= turns; ++i) {
      const Point2& at = points[leg - 1];
      poses.push_back({at.x(), at.y(), wrap_angle(before + turn * i / turns)});
    }
    const int steps = static_cast<int>(std::ceil(along.norm() / robot.step_m));
    for (int i = poses.empty() ? 0 : 1; i <= steps; ++i) {
      const Point2 at = points[leg - 1] + along * i / steps;
      poses.push_back({at.x(), at.y(), wrap_angle(heading)});
    }
  }
  return poses;
}

inline float range_to(const std::vector<Segment2>& surfaces, const Pose2& world_from_beam,
                      double max_range_m) {
  const Segment2 ray{world_from_beam.position(), world_from_beam * Point2(max_range_m, 0.0)};
  double nearest = 1.0;
  for (const Segment2& surface : surfaces) {
    nearest = std::min(nearest, crossing_fraction(ray, surface).value_or(1.0));
  }
  return static_cast<float>(nearest * max_range_m);
}

/// What the robot reads along way-points, every 0.1 s.
inline std::vector<RangeReading> readings_along(const std::vector<Segment2>& surfaces,
                                                const Polyline& points,
                                                const LaserRobot& robot = {}) {
  const auto sensor = sensor_of(robot);
  std::mt19937 random(7);
  std::normal_distribution<float> unit;
  std::vector<RangeReading> readings;
  for (const Pose2& world_from_robot : poses_along(points, robot)) {
    RangeReading reading{robot.start_s + 0.1 * static_cast<double>(readings.size()),
                         robot.odom_from_world * world_from_robot,
                         sensor,
                         {}};
    for (const Pose2& robot_from_beam : sensor->robot_from_beam) {
      const float range_m =
          range_to(surfaces, world_from_robot * robot_from_beam, robot.max_range_m);
      reading.ranges_m.push_back(range_m + static_cast<float>(robot.noise_m) * unit(random));
    }
    readings.push_back(std::move(reading));
  }
  return readings;
}

/// Drives along the drawing's own way-points.
inline std::vector<RangeReading> readings_in(const WorldDrawing& drawing,
                                             const LaserRobot& robot = {}) {
  return readings_along(surfaces_of(drawing), way_points_of(drawing), robot);
}

}  // namespace roomatlas::test
