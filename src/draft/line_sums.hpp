// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "roomatlas/core/geometry.hpp"

namespace roomatlas {

/// A line through points.
struct FittedLine {
  Point2 middle = Point2::Zero();
  double direction_rad = 0.0;  ///< modulo 180 degrees
  double rms_m = 0.0;          ///< of the points' distances from it
};

/// Sums over points, by which the line through them by total least squares follows. Those of a
/// stretch are the difference of those up to its two ends.
struct LineSums {
  double weight = 0.0;
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

  /// @param at from an origin near all points, so that squares stay small
  void add(const Point2& at, double with_weight = 1.0) {
    weight += with_weight;
    x += with_weight * at.x();
    y += with_weight * at.y();
    xx += with_weight * at.x() * at.x();
    xy += with_weight * at.x() * at.y();
    yy += with_weight * at.y() * at.y();
  }

  [[nodiscard]] LineSums operator-(const LineSums& from) const {
    return {weight - from.weight, x - from.x, y - from.y, xx - from.xx, xy - from.xy, yy - from.yy};
  }

  /// The principal component. Not without weight.
  [[nodiscard]] FittedLine line() const {
    const Point2 middle(x / weight, y / weight);
    const double var_x = xx / weight - middle.x() * middle.x();
    const double var_xy = xy / weight - middle.x() * middle.y();
    const double var_y = yy / weight - middle.y() * middle.y();
    const double smaller = (var_x + var_y - std::hypot(var_x - var_y, 2.0 * var_xy)) / 2.0;
    return {middle, 0.5 * std::atan2(2.0 * var_xy, var_x - var_y),
            std::sqrt(std::max(0.0, smaller))};
  }
};

}  // namespace roomatlas
