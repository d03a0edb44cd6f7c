// SPDX-License-Identifier: GPL-3.0-or-later
// Maps of drawn rooms, from sweeps at true poses, and maps made of literal faces.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "roomatlas/match/local_map.hpp"
#include "support/drawn_world.hpp"

namespace roomatlas::test {

/// 7.8 m x 4.5 m with a niche and a pillar, so that no two places look alike.
const WorldDrawing kUnevenRoom = {"############################",  //
                                  "#              #           #",  //
                                  "#              #           #",  //
                                  "#  d                c      #",  //
                                  "#                          #",  //
                                  "#                          #",  //
                                  "#         ##               #",  //
                                  "#         ##               #",  //
                                  "#                          #",  //
                                  "#                          #",  //
                                  "#  a                b      #",  //
                                  "#                        ###",  //
                                  "#                        ###",  //
                                  "#                        ###",  //
                                  "############################"};

/// The map of sweeps whose odometry is the truth.
/// @param map_from_world where the map has its frame
inline LocalMap map_of(const std::vector<RangeReading>& readings, const Pose2& map_from_world = {},
                       double cell_m = 0.1) {
  LocalMap map(cell_m);
  for (const RangeReading& reading : readings) {
    map.add(scan_of(reading, {}), map_from_world * reading.odom_from_robot);
  }
  return map;
}

/// Every n-th of many.
template <typename Value>
std::vector<Value> every(std::size_t n, const std::vector<Value>& values) {
  std::vector<Value> some;
  for (std::size_t i = 0; i < values.size(); i += n) some.push_back(values[i]);
  return some;
}

/// A map with these faces, one hit each, seen without any rays through free space.
inline LocalMap map_with(const std::vector<ScanPoint>& faces) {
  LocalMap map(0.1);
  for (const ScanPoint& face : faces) map.add({face.position, {face}}, {});
  return map;
}

/// Faces along a straight wall, one a tenth of a metre, looking to the left of its direction.
inline std::vector<ScanPoint> wall_between(const Point2& from, const Point2& to) {
  const Point2 along = to - from;
  const auto count = static_cast<int>(along.norm() / 0.1 + 0.5);
  const Point2 normal = Point2(-along.y(), along.x()) / along.norm();
  std::vector<ScanPoint> faces;
  for (int i = 0; i < count; ++i) {
    faces.push_back({from + along * ((i + 0.5) / count), normal, true});
  }
  return faces;
}

/// The same points as a robot at this pose has them in its frame.
inline std::vector<ScanPoint> seen_from(const Pose2& map_from_robot,
                                        const std::vector<ScanPoint>& points_map) {
  const Pose2 robot_from_map = inverse(map_from_robot);
  const Pose2 turn{0.0, 0.0, robot_from_map.theta_rad};
  std::vector<ScanPoint> points;
  for (const ScanPoint& point : points_map) {
    points.push_back({robot_from_map * point.position, turn * point.normal, point.is_hit});
  }
  return points;
}

/// How far a ray goes until it meets a disc, a person as a rule; infinite where it misses it.
inline double to_disc_m(const Point2& from, const Point2& ray, const Point2& middle,
                        double radius_m = 0.22) {
  const Point2 off = middle - from;
  const double along_m = off.dot(ray);
  const double square = radius_m * radius_m - off.squaredNorm() + along_m * along_m;
  const bool is_met = square > 0.0 && along_m > 0.0;
  return is_met ? along_m - std::sqrt(square) : std::numeric_limits<double>::infinity();
}

inline double turn_deg(const Pose2& a, const Pose2& b) {
  return std::abs(degrees(wrap_angle(a.theta_rad - b.theta_rad)));
}

}  // namespace roomatlas::test
