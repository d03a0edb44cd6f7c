// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/rigid_fit.hpp"

#include <cmath>

#include "roomatlas/core/geometry.hpp"

namespace roomatlas {

Pose2 rigid_fit(const std::vector<PointPair>& pairs) {
  double weights = 0.0;
  Point2 mean_from = Point2::Zero();
  Point2 mean_to = Point2::Zero();
  for (const PointPair& pair : pairs) {
    weights += pair.weight;
    mean_from += pair.weight * pair.from;
    mean_to += pair.weight * pair.to;
  }
  if (!(weights > 0.0)) return {};
  mean_from /= weights;
  mean_to /= weights;
  double sine = 0.0;
  double cosine = 0.0;
  for (const PointPair& pair : pairs) {
    sine += pair.weight * cross(pair.from - mean_from, pair.to - mean_to);
    cosine += pair.weight * (pair.from - mean_from).dot(pair.to - mean_to);
  }
  const Pose2 turn{0.0, 0.0, wrap_angle(std::atan2(sine, cosine))};
  const Point2 shift = mean_to - turn * mean_from;
  return {shift.x(), shift.y(), turn.theta_rad};
}

}  // namespace roomatlas
