// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"

#include <Eigen/Geometry>

#include <optional>

namespace roomatlas::io {

/// A rigid transform of space, SE(3), named as Pose2 is: `a_from_b`.
struct Transform3 {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< unit
};

[[nodiscard]] Transform3 operator*(const Transform3& a_from_b, const Transform3& b_from_c);
[[nodiscard]] Eigen::Vector3d operator*(const Transform3& a_from_b, const Eigen::Vector3d& point_b);
[[nodiscard]] Transform3 inverse(const Transform3& a_from_b);
/// Part way: positions linearly, rotations along the shorter great circle. 0 and 1 give the ends.
[[nodiscard]] Transform3 interpolate(const Transform3& from, const Transform3& to, double fraction);
/// As seen from above: position, and where the x axis points.
[[nodiscard]] Pose2 planar(const Transform3& a_from_b);
/// A pose of the plane, at height zero.
[[nodiscard]] Transform3 upright(const Pose2& a_from_b);
/// Whether they differ by less than any laser's mount is known to.
[[nodiscard]] bool is_same(const Transform3& one, const Transform3& other);

/// From the numbers of a message; nothing where one is not finite, the position is farther than a
/// coordinate can be, or the quaternion's length is not near one (all zero: it was never filled
/// in).
[[nodiscard]] std::optional<Transform3> sound_transform(const Eigen::Vector3d& translation,
                                                        const Eigen::Quaterniond& rotation);

}  // namespace roomatlas::io
