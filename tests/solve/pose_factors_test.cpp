// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/solve/pose_factors.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "../../src/solve/whitening.hpp"
#include "support/factor_checks.hpp"

namespace roomatlas {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::Angles;
using test::evaluate;
using test::expect_jacobian_is_numeric;
using test::jumps;

/// Positive definite, with strong terms beside the diagonal.
const Matrix3d kOmega = (Matrix3d() << 9, 3, -2, 3, 6, 1, -2, 1, 4).finished();

TEST(RelativePoseFactor, HasTheJacobianOfItsResidualAlsoAtAnglesNearHalfATurn) {
  Angles random;
  for (int i = 0; i < 300; ++i) {
    const Pose2 measured{random.coordinate_m(), random.coordinate_m(), random.next()};
    VectorXd state(6);
    state << random.coordinate_m(), random.coordinate_m(), random.next(), random.coordinate_m(),
        random.coordinate_m(), random.next();
    if (jumps(state(5) - state(2) - measured.theta_rad)) continue;
    expect_jacobian_is_numeric(RelativePoseFactor(measured, kOmega), state);
  }
}

TEST(Whitening, GivesTheInformationMatrixBackAsTheSquareOfAResidualsLength) {
  const Vector3d residual(0.7, -1.1, 0.4);
  const double expected = residual.dot(kOmega * residual);
  EXPECT_NEAR((whitening(kOmega) * residual).squaredNorm(), expected, 1e-12);
  EXPECT_TRUE((whitening(kOmega).transpose() * whitening(kOmega)).isApprox(kOmega, 1e-12));
  EXPECT_TRUE(whitening(kOmega).isUpperTriangular());
  const Matrix3d lower = kOmega.llt().matrixL();
  EXPECT_GT(std::abs((lower * residual).squaredNorm() - expected), 0.5) << "the lower factor";
}

TEST(RelativePoseFactor, IsZeroWhereTheMeasurementHoldsAndSeesItInItsOwnFrame) {
  // i stands at (1, 2) looking up the y axis; j is 3 m ahead of it and 1 m to its left, turned
  // right by a quarter: at (0, 5), looking along x
  const Pose2 i_from_j{3.0, 1.0, -kPi / 2.0};
  const RelativePoseFactor factor(i_from_j, Matrix3d::Identity());
  VectorXd state(6);
  state << 1, 2, kPi / 2, 0, 5, 0;
  EXPECT_LT(evaluate(factor, state).residuals.norm(), 1e-12);
  // 0.2 m along the building's x is 0.2 m along x of j as measured, which looks that way
  state(3) += 0.2;
  state(5) += 0.1;
  EXPECT_LT((evaluate(factor, state).residuals - Vector3d(0.2, 0.0, 0.1)).norm(), 1e-12);
}

TEST(RelativePoseFactor, HasTheResidualOfItsEquation) {
  Angles random;
  for (int i = 0; i < 50; ++i) {
    const Pose2 world_from_i{random.coordinate_m(), random.coordinate_m(), random.next()};
    const Pose2 world_from_j{random.coordinate_m(), random.coordinate_m(), random.next()};
    const Pose2 i_from_j{random.coordinate_m(), random.coordinate_m(), random.next()};
    // the pose of j as it is, seen from j as measured
    const Pose2 error = inverse(i_from_j) * (inverse(world_from_i) * world_from_j);
    VectorXd state(6);
    state << world_from_i.x_m, world_from_i.y_m, world_from_i.theta_rad, world_from_j.x_m,
        world_from_j.y_m, world_from_j.theta_rad;
    const VectorXd residuals =
        evaluate(RelativePoseFactor(i_from_j, Matrix3d::Identity()), state).residuals;
    EXPECT_NEAR(residuals(0), error.x_m, 1e-9);
    EXPECT_NEAR(residuals(1), error.y_m, 1e-9);
    EXPECT_NEAR(wrap_angle(residuals(2) - error.theta_rad), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace roomatlas
