// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/pose2.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace roomatlas {
namespace {

TEST(WrapAngle, StaysInTheHalfOpenIntervalAndKeepsTheDirection) {
  for (double angle = -50.0; angle < 50.0; angle += 0.37) {
    const double wrapped = wrap_angle(angle);
    EXPECT_GE(wrapped, -kPi);
    EXPECT_LT(wrapped, kPi);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-12);
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-12);
  }
  EXPECT_EQ(wrap_angle(kPi), -kPi);
  EXPECT_EQ(wrap_angle(-kPi), -kPi);
}

TEST(Pose2, ComposesLikeHomogeneousMatrices) {
  const Pose2 a{1.0, -2.0, 2.5};
  const Pose2 b{0.3, 4.0, 1.9};
  const auto matrix = [](const Pose2& p) {
    return Eigen::Isometry2d(Eigen::Translation2d(p.x_m, p.y_m) * Eigen::Rotation2Dd(p.theta_rad));
  };
  const Pose2 ab = a * b;
  EXPECT_TRUE(matrix(ab).isApprox(matrix(a) * matrix(b), 1e-12));
  EXPECT_TRUE(matrix(inverse(a)).isApprox(matrix(a).inverse(), 1e-12));
}

TEST(Pose2, InterpolatesAlongTheShorterArc) {
  const Pose2 middle = interpolate({0, 0, 3.0}, {2, 4, -3.0}, 0.5);
  EXPECT_NEAR(middle.x_m, 1.0, 1e-12);
  EXPECT_NEAR(middle.y_m, 2.0, 1e-12);
  EXPECT_NEAR(std::abs(middle.theta_rad), kPi, 1e-12);
}

TEST(WrapAngle, TakesAnglesThatNobodyCanHaveTurned) {
  for (const double angle : {1e16, -1e20, 1e300, 3e15}) {
    EXPECT_GE(wrap_angle(angle), -kPi) << angle;
    EXPECT_LT(wrap_angle(angle), kPi) << angle;
    EXPECT_LE(std::abs(wrap_quarter(angle)), kPi / 4.0) << angle;
  }
  EXPECT_TRUE(std::isnan(wrap_angle(std::nan(""))));
  EXPECT_TRUE(std::isnan(wrap_quarter(std::nan(""))));
}

}  // namespace
}  // namespace roomatlas
