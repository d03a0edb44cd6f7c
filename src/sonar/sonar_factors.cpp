// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_factors.hpp"

#include <cmath>

namespace roomatlas {
namespace {

/// Turned left by 90 degrees: the derivative of a vector by the heading that carries it.
Point2 turned_left(const Point2& v) { return {-v.y(), v.x()}; }

}  // namespace

std::array<PairResidual, 3> step_residuals(const Pose2& map_from_first,
                                           const Pose2& map_from_second,
                                           const Pose2& first_from_second) {
  const Point2 ahead = direction(map_from_first.theta_rad);
  const Point2 left = turned_left(ahead);
  const Point2 step = map_from_second.position() - map_from_first.position();
  const double along = ahead.dot(step);
  const double across = left.dot(step);
  std::array<PairResidual, 3> residuals;
  residuals[0] = {
      along - first_from_second.x_m, {-ahead.x(), -ahead.y(), across}, {ahead.x(), ahead.y(), 0.0}};
  residuals[1] = {
      across - first_from_second.y_m, {-left.x(), -left.y(), -along}, {left.x(), left.y(), 0.0}};
  residuals[2] = {wrap_angle(map_from_second.theta_rad - map_from_first.theta_rad -
                             first_from_second.theta_rad),
                  {0.0, 0.0, -1.0},
                  {0.0, 0.0, 1.0}};
  return residuals;
}

PlacedWall placed(const SeenWall& wall, const Pose2& map_from_node,
                  const PointTransform& transform) {
  PlacedWall at;
  at.normal_rad = map_from_node.theta_rad + wall.normal_rad;
  at.normal = direction(at.normal_rad);
  at.node = map_from_node.position();
  at.to_middle = transform * wall.middle_node - at.node;
  at.turned = at.normal.dot(turned_left(at.to_middle));
  return at;
}

Point2 point_on(const SeenWall& wall, double along_m) {
  return wall.middle_node + along_m * turned_left(direction(wall.normal_rad));
}

PairResidual across_residual(const PlacedWall& first, const Point2& second, const Point2& point) {
  const Point2& normal = first.normal;
  const Point2 to_point = point - second;
  const Point2 between = second + to_point - first.node - first.to_middle;
  PairResidual residual;
  residual.value = normal.dot(between);
  residual.by_first = {-normal.x(), -normal.y(), turned_left(normal).dot(between) - first.turned};
  residual.by_second = {normal.x(), normal.y(), normal.dot(turned_left(to_point))};
  return residual;
}

PairResidual across_residual(const Pose2& map_from_first, const SeenWall& first,
                             const Pose2& map_from_second, const SeenWall& second, double along_m) {
  return across_residual(placed(first, map_from_first, PointTransform(map_from_first)),
                         map_from_second.position(), map_from_second * point_on(second, along_m));
}

double range_by_heading(const ConeReturn& from, double half_cone_rad, const ConeLine& line) {
  const double off = wrap_angle(line.normal_rad - from.axis_rad);
  const double beyond = std::abs(off) - half_cone_rad;
  if (beyond <= 0.0) return 0.0;
  return (off > 0.0 ? -1.0 : 1.0) * from.range_m * std::tan(beyond);
}

std::optional<PairResidual> range_residual(const Pose2& map_from_first, const SeenReturn& seen,
                                           const Pose2& map_from_second, const SeenWall& wall) {
  const Pose2 sonar = map_from_first * seen.node_from_sonar;
  const ConeReturn heard{sonar.position(), sonar.theta_rad, seen.range_m};
  const PlacedWall placed_wall = placed(wall, map_from_second, PointTransform(map_from_second));
  const Point2& normal = placed_wall.normal;
  ConeLine line{wrap_angle(placed_wall.normal_rad)};
  line.offset_m = normal.dot(Point2(placed_wall.node + placed_wall.to_middle));
  const auto expected_m = range_to_line(heard, seen.half_cone_rad, line);
  if (!expected_m) return std::nullopt;
  const double distance_m = line.offset_m - normal.dot(heard.sonar);
  const double per_distance = *expected_m / distance_m;
  const double by_turn =
      range_by_heading({heard.sonar, heard.axis_rad, *expected_m}, seen.half_cone_rad, line);
  const Point2 arm = heard.sonar - map_from_first.position();
  const Point2 between = placed_wall.node + placed_wall.to_middle - heard.sonar;
  PairResidual residual;
  residual.value = *expected_m - seen.range_m;
  residual.by_first = {-normal.x() * per_distance, -normal.y() * per_distance,
                       -normal.dot(turned_left(arm)) * per_distance + by_turn};
  residual.by_second = {
      normal.x() * per_distance, normal.y() * per_distance,
      (turned_left(normal).dot(between) + placed_wall.turned) * per_distance - by_turn};
  return residual;
}

}  // namespace roomatlas
