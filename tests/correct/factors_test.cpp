// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/correct/factors.hpp"

#include <gtest/gtest.h>

#include "support/factor_checks.hpp"

namespace roomatlas {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using test::Angles;
using test::evaluate;
using test::expect_jacobian_is_numeric;
using test::jumps;

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
