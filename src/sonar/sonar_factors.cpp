// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_factors.hpp"

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

PairResidual across_residual(const Pose2& map_from_first, const SeenWall& first,
                             const Pose2& map_from_second, const SeenWall& second, double along_m) {
  const Point2 normal = direction(map_from_first.theta_rad + first.normal_rad);
  const Point2 to_middle = map_from_first * first.middle_node - map_from_first.position();
  const Point2 point_node =
      second.middle_node + along_m * turned_left(direction(second.normal_rad));
  const Point2 to_point = map_from_second * point_node - map_from_second.position();
  const Point2 between =
      map_from_second.position() + to_point - map_from_first.position() - to_middle;
  PairResidual residual;
  residual.value = normal.dot(between);
  residual.by_first = {-normal.x(), -normal.y(),
                       turned_left(normal).dot(between) - normal.dot(turned_left(to_middle))};
  residual.by_second = {normal.x(), normal.y(), normal.dot(turned_left(to_point))};
  return residual;
}

}  // namespace roomatlas
