// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/transform3.hpp"

#include "roomatlas/mission/plausible.hpp"

#include <cmath>

namespace roomatlas::io {

Transform3 operator*(const Transform3& a_from_b, const Transform3& b_from_c) {
  return {a_from_b * b_from_c.translation, (a_from_b.rotation * b_from_c.rotation).normalized()};
}

Eigen::Vector3d operator*(const Transform3& a_from_b, const Eigen::Vector3d& point_b) {
  return a_from_b.translation + a_from_b.rotation * point_b;
}

Transform3 inverse(const Transform3& a_from_b) {
  const Eigen::Quaterniond back = a_from_b.rotation.conjugate();
  return {-(back * a_from_b.translation), back};
}

Transform3 interpolate(const Transform3& from, const Transform3& to, double fraction) {
  return {from.translation + fraction * (to.translation - from.translation),
          from.rotation.slerp(fraction, to.rotation)};
}

Pose2 planar(const Transform3& a_from_b) {
  const Eigen::Quaterniond& rotation = a_from_b.rotation;
  if (rotation.x() == 0.0 && rotation.y() == 0.0) {  // about the vertical: to the last digit
    return {a_from_b.translation.x(), a_from_b.translation.y(),
            wrap_angle(2.0 * std::atan2(rotation.z(), rotation.w()))};
  }
  const Eigen::Vector3d ahead = rotation * Eigen::Vector3d::UnitX();
  return {a_from_b.translation.x(), a_from_b.translation.y(),
          wrap_angle(std::atan2(ahead.y(), ahead.x()))};
}

Transform3 upright(const Pose2& a_from_b) {
  return {{a_from_b.x_m, a_from_b.y_m, 0.0},
          Eigen::Quaterniond(Eigen::AngleAxisd(a_from_b.theta_rad, Eigen::Vector3d::UnitZ()))};
}

bool is_same(const Transform3& one, const Transform3& other) {
  constexpr double kSameM = 1e-5;
  constexpr double kSameRad = 1e-5;
  return (one.translation - other.translation).norm() < kSameM &&
         one.rotation.angularDistance(other.rotation) < kSameRad;
}

std::optional<Transform3> sound_transform(const Eigen::Vector3d& translation,
                                          const Eigen::Quaterniond& rotation) {
  constexpr double kOffUnit = 0.1;  // of a quaternion's length; some are written with few digits
  const double length = rotation.norm();
  if (!translation.allFinite() || translation.cwiseAbs().maxCoeff() > kFarthest_m ||
      !(std::abs(length - 1.0) < kOffUnit)) {
    return std::nullopt;
  }
  return Transform3{translation, Eigen::Quaterniond(rotation.coeffs() / length)};
}

}  // namespace roomatlas::io
