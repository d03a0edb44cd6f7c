// SPDX-License-Identifier: GPL-3.0-or-later
// Visits drawn by hand: walls, and the floor that is seen from where the robot was.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "roomatlas/loops/closures.hpp"

namespace roomatlas::test {

struct DrawnWall {
  Point2 from;
  Point2 to;
};

/// Walls of a rectangle with one corner at (x, y), and a box in it that tells its ends apart.
inline std::vector<DrawnWall> room_walls(double x, double y, double width, double height,
                                         double box_m) {
  const auto rectangle = [](double x0, double y0, double w, double h) {
    return std::vector<DrawnWall>{{{x0, y0}, {x0 + w, y0}},
                                  {{x0 + w, y0}, {x0 + w, y0 + h}},
                                  {{x0 + w, y0 + h}, {x0, y0 + h}},
                                  {{x0, y0 + h}, {x0, y0}}};
  };
  std::vector<DrawnWall> walls = rectangle(x, y, width, height);
  if (box_m > 0.0) {
    for (const DrawnWall& wall : rectangle(x, y, box_m, box_m / 2.0)) walls.push_back(wall);
  }
  return walls;
}

/// How far a ray goes before it meets a wall; nothing beyond 50 m.
inline std::optional<double> range_to(const std::vector<DrawnWall>& walls, const Point2& from,
                                      const Point2& along) {
  std::optional<double> least;
  for (const DrawnWall& wall : walls) {
    const Point2 edge = wall.to - wall.from;
    const double cross = along.x() * edge.y() - along.y() * edge.x();
    if (std::abs(cross) < 1e-12) continue;
    const Point2 off = wall.from - from;
    const double range = (off.x() * edge.y() - off.y() * edge.x()) / cross;
    const double share = (off.x() * along.y() - off.y() * along.x()) / cross;
    if (range <= 0.0 || range > 50.0 || share < 0.0 || share > 1.0) continue;
    least = std::min(least.value_or(range), range);
  }
  return least;
}

/// What a laser sees from some places, in the frame of `asr_from_world`.
inline AsrShape seen_shape(AsrId id, const std::vector<DrawnWall>& walls,
                           const std::vector<Point2>& places, const Pose2& asr_from_world) {
  AsrShape shape;
  shape.id = id;
  shape.map = LocalMap(0.1);
  const ScanOptions options;
  for (const Point2& at : places) {
    RangeSensor sensor;
    sensor.max_range_m = 30.0;
    RangeReading reading;
    for (int beam = 0; beam < 360; ++beam) {
      const double angle_rad = radians(beam - 180.0);
      sensor.robot_from_beam.push_back({0.0, 0.0, angle_rad});
      reading.ranges_m.push_back(
          static_cast<float>(range_to(walls, at, direction(angle_rad)).value_or(30.0)));
    }
    reading.sensor = std::make_shared<const RangeSensor>(sensor);
    const Pose2 asr_from_robot = asr_from_world * Pose2{at.x(), at.y(), 0.0};
    for (int again = 0; again < 3; ++again) {
      shape.map.add(scan_of(reading, options), asr_from_robot);
    }
    shape.path.push_back(asr_from_robot.position());
  }
  shape.points = points_of(shape.map, MatchMapsOptions{});
  return shape;
}

}  // namespace roomatlas::test
