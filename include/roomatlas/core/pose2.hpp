// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace roomatlas {

using Point2 = Eigen::Vector2d;  ///< metres, in the frame that the variable's name gives

/// Wraps an angle into [-pi, pi). The only place where angles wrap.
/// @param angle_rad any finite angle; a NaN stays NaN.
[[nodiscard]] inline double wrap_angle(double angle_rad);

/// Wraps an angle into [-pi/4, pi/4): what is left of it modulo 90 degrees.
[[nodiscard]] double wrap_quarter(double angle_rad);

constexpr double kPi = 3.14159265358979323846;  ///< half a turn
[[nodiscard]] constexpr double degrees(double angle_rad) { return angle_rad * 180.0 / kPi; }
[[nodiscard]] constexpr double radians(double angle_deg) { return angle_deg * kPi / 180.0; }

/// `wrap_angle` of what lies beyond its range.
[[nodiscard]] double wrap_from_afar(double angle_rad);

inline double wrap_angle(double angle_rad) {
  return angle_rad >= -kPi && angle_rad < kPi ? angle_rad : wrap_from_afar(angle_rad);
}

/// A rigid transform of the plane, SE(2). A variable `a_from_b` maps coordinates in frame b to
/// frame a, and equally is the pose of b's origin in a; so `a_from_b * b_from_c == a_from_c`.
struct Pose2 {
  double x_m = 0.0;
  double y_m = 0.0;
  double theta_rad = 0.0;  ///< [-pi, pi) for every pose this library returns

  [[nodiscard]] Point2 position() const { return {x_m, y_m}; }
  [[nodiscard]] bool operator==(const Pose2&) const = default;
};

[[nodiscard]] Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c);
[[nodiscard]] Point2 operator*(const Pose2& a_from_b, const Point2& point_b);
[[nodiscard]] Pose2 inverse(const Pose2& a_from_b);

/// The same transform with its cosine and sine worked out once, for many points: the same bits.
class PointTransform {
 public:
  explicit PointTransform(const Pose2& a_from_b);
  [[nodiscard]] Point2 operator*(const Point2& point_b) const {
    return {x_m_ + cosine_ * point_b.x() - sine_ * point_b.y(),
            y_m_ + sine_ * point_b.x() + cosine_ * point_b.y()};
  }
  /// @param a_from_b the pose that this was made of
  [[nodiscard]] Pose2 pose(const Pose2& a_from_b, const Pose2& b_from_c) const {
    const Point2 position = *this * b_from_c.position();
    return {position.x(), position.y(), wrap_angle(a_from_b.theta_rad + b_from_c.theta_rad)};
  }

 private:
  double x_m_;
  double y_m_;
  double cosine_;
  double sine_;
};

/// The unit vector at `angle_rad` from the x axis.
[[nodiscard]] Point2 direction(double angle_rad);

/// The pose part way from `from` to `to`: positions linearly, headings along the shorter arc.
/// @param fraction 0 gives `from`, 1 gives `to`; values outside extrapolate.
[[nodiscard]] Pose2 interpolate(const Pose2& from, const Pose2& to, double fraction);

/// A pose with the time at which it held. Logs may step back in time: sequences of these are in
/// file order, never sorted.
struct StampedPose {
  double timestamp_s = 0.0;
  Pose2 pose;
};

using Trajectory = std::vector<StampedPose>;

}  // namespace roomatlas
