// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/pose2.hpp"

#include <cmath>

#include "roomatlas/core/floored.hpp"

namespace roomatlas {
namespace {

/// Beyond it, and of what is no number, there are no turns to be counted.
bool is_far(double angle_rad) { return !(std::abs(angle_rad) < 1e15); }

}  // namespace

double wrap_from_afar(double angle_rad) {
  const double wrapped =
      is_far(angle_rad)
          ? std::remainder(angle_rad, 2.0 * kPi)
          : angle_rad - 2.0 * kPi * static_cast<double>(floored((angle_rad + kPi) / (2.0 * kPi)));
  return wrapped >= kPi ? -kPi : wrapped;  // rounding may land on +pi
}

double wrap_quarter(double angle_rad) {
  constexpr double kQuarter = kPi / 2.0;  // of a turn
  if (is_far(angle_rad)) return std::remainder(angle_rad, kQuarter);
  return angle_rad - kQuarter * static_cast<double>(floored(angle_rad / kQuarter + 0.5));
}

Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c) {
  const Point2 position = a_from_b * b_from_c.position();
  return {position.x(), position.y(), wrap_angle(a_from_b.theta_rad + b_from_c.theta_rad)};
}

PointTransform::PointTransform(const Pose2& a_from_b)
    : x_m_(a_from_b.x_m),
      y_m_(a_from_b.y_m),
      cosine_(std::cos(a_from_b.theta_rad)),
      sine_(std::sin(a_from_b.theta_rad)) {}

Point2 operator*(const Pose2& a_from_b, const Point2& point_b) {
  return PointTransform(a_from_b) * point_b;
}

Pose2 inverse(const Pose2& a_from_b) {
  const double c = std::cos(a_from_b.theta_rad);
  const double s = std::sin(a_from_b.theta_rad);
  return {-c * a_from_b.x_m - s * a_from_b.y_m, s * a_from_b.x_m - c * a_from_b.y_m,
          wrap_angle(-a_from_b.theta_rad)};
}

Point2 direction(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

Pose2 interpolate(const Pose2& from, const Pose2& to, double fraction) {
  return {from.x_m + fraction * (to.x_m - from.x_m), from.y_m + fraction * (to.y_m - from.y_m),
          wrap_angle(from.theta_rad + fraction * wrap_angle(to.theta_rad - from.theta_rad))};
}

}  // namespace roomatlas
