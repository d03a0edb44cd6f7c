// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/correct/factors.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>

#include "correct/numeric_derivative.hpp"

namespace roomatlas {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Positive definite, with strong terms beside the diagonal.
const Matrix3d kOmega = (Matrix3d() << 9, 3, -2, 3, 6, 1, -2, 1, 4).finished();

/// The factor's value and Jacobian with all its parameter blocks in one vector.
struct Evaluated {
  VectorXd residuals;
  RowMajor jacobian;
};

Evaluated evaluate(const ceres::CostFunction& factor, const VectorXd& state) {
  const auto& sizes = factor.parameter_block_sizes();
  std::vector<const double*> parameters;
  std::vector<RowMajor> blocks;
  Eigen::Index offset = 0;
  for (const int size : sizes) {
    parameters.push_back(state.data() + offset);
    blocks.emplace_back(factor.num_residuals(), size);
    offset += size;
  }
  std::vector<double*> jacobians;
  for (RowMajor& block : blocks) jacobians.push_back(block.data());
  Evaluated result{VectorXd(factor.num_residuals()), RowMajor(factor.num_residuals(), offset)};
  EXPECT_EQ(offset, state.size());
  EXPECT_TRUE(factor.Evaluate(parameters.data(), result.residuals.data(), jacobians.data()));
  offset = 0;
  for (const RowMajor& block : blocks) {
    result.jacobian.middleCols(offset, block.cols()) = block;
    offset += block.cols();
  }
  return result;
}

void expect_jacobian_is_numeric(const ceres::CostFunction& factor, const VectorXd& state) {
  const auto value = [&](const VectorXd& at) { return evaluate(factor, at).residuals; };
  const Eigen::MatrixXd numeric = test::numeric_jacobian(value, state);
  EXPECT_LT((evaluate(factor, state).jacobian - numeric).cwiseAbs().maxCoeff(), 1e-6)
      << "at " << state.transpose();
}

/// Any angle, but often one within a degree of +-pi.
class Angles {
 public:
  double next() {
    const double any = uniform_(random_) * kPi;
    const double near_pi = kPi + uniform_(random_) * radians(1.0);
    return near_(random_) ? wrap_angle(near_pi) : any;
  }
  double coordinate_m() { return 10.0 * uniform_(random_); }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
  std::bernoulli_distribution near_{0.5};
};

/// At an error of half a turn the residual jumps, and has no derivative.
bool jumps(double error_rad) { return std::abs(std::abs(wrap_angle(error_rad)) - kPi) < 1e-3; }

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

TEST(RelativeHeadingFactor, HasTheJacobianOfItsResidualAlsoAtAnglesNearHalfATurn) {
  Angles random;
  for (int i = 0; i < 300; ++i) {
    const double measured = random.next();
    const Eigen::Vector2d state(random.next(), random.next());
    if (jumps(state(1) - state(0) - measured)) continue;
    expect_jacobian_is_numeric(RelativeHeadingFactor(measured, 0.05), state);
  }
}

TEST(WallDirectionFactor, HasTheJacobianOfItsResidualOnAPoseAndOnAHeading) {
  Angles random;
  for (int i = 0; i < 300; ++i) {
    const double offset = random.next();
    const double heading = random.next();
    const double building = random.next();
    if (jumps(heading + offset - building)) continue;
    expect_jacobian_is_numeric(WallDirectionFactor<1>(offset, 0.05),
                               Eigen::Vector2d(heading, building));
    expect_jacobian_is_numeric(
        WallDirectionFactor<3>(offset, 0.05),
        Eigen::Vector4d(random.coordinate_m(), random.coordinate_m(), heading, building));
  }
}

TEST(PivotLoopFactor, HasTheJacobianOfItsResidualForLoopsOfAnyLength) {
  Angles random;
  for (int length = 1; length <= 6; ++length) {
    std::vector<Point2> steps_m;
    VectorXd headings(length);
    for (int k = 0; k < length; ++k) {
      steps_m.emplace_back(random.coordinate_m(), random.coordinate_m());
      headings(k) = random.next();
    }
    expect_jacobian_is_numeric(PivotLoopFactor(steps_m, 0.3), headings);
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

TEST(HeadingFactors, WrapTheirErrorBeforeTheyDivideBySigma) {
  const Eigen::Vector2d across(radians(179), radians(-178));
  EXPECT_NEAR(evaluate(RelativeHeadingFactor(radians(1), radians(2)), across).residuals(0), 1.0,
              1e-9);
  EXPECT_NEAR(evaluate(WallDirectionFactor<1>(radians(-1), radians(2)), across).residuals(0), -2.0,
              1e-9);
}

TEST(PivotLoopFactor, AddsTheStepsTurnedByTheirHeadings) {
  // 4 m along x, 3 m along y, then in a frame turned by half a turn 5 m along its x and 1 along y:
  // (4, 0) + (0, 3) + (-5, -1) = (-1, 2); a sigma of 0.5 m doubles it
  const PivotLoopFactor factor({{4, 0}, {3, 0}, {5, 1}}, 0.5);
  const VectorXd residuals = evaluate(factor, Vector3d(0.0, kPi / 2.0, kPi)).residuals;
  ASSERT_EQ(residuals.size(), 2);
  EXPECT_NEAR(residuals(0), -2.0, 1e-12);
  EXPECT_NEAR(residuals(1), 4.0, 1e-12);
}

TEST(PivotLoopFactor, IsZeroAroundASquare) {
  const PivotLoopFactor factor({{3, 0}, {3, 0}, {3, 0}, {3, 0}}, 0.1);
  const Eigen::Vector4d headings(0.4, 0.4 + kPi / 2, 0.4 + kPi, 0.4 - kPi / 2);
  EXPECT_LT(evaluate(factor, headings).residuals.norm(), 1e-12);
}

}  // namespace
}  // namespace roomatlas
