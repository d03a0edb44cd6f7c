// SPDX-License-Identifier: GPL-3.0-or-later
// The batch's derivatives against numeric ones.
#include "../../src/sonar/sonar_factors.hpp"

#include <gtest/gtest.h>

#include "support/numeric_derivative.hpp"
#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

Pose2 pose_of(const Eigen::VectorXd& v, Eigen::Index from) {
  return {v(from), v(from + 1), v(from + 2)};
}

Eigen::VectorXd two_poses() {
  Eigen::VectorXd v(6);
  v << 1.3, -0.4, 0.7, 4.1, 2.2, -2.3;
  return v;
}

void expect_derivatives(const PairResidual& residual, const Eigen::MatrixXd& numeric) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    EXPECT_NEAR(residual.by_first[static_cast<std::size_t>(i)], numeric(0, i), 1e-7) << i;
    EXPECT_NEAR(residual.by_second[static_cast<std::size_t>(i)], numeric(0, i + 3), 1e-7) << i;
  }
}

TEST(StepResiduals, HaveTheDerivativesOfTheirValues) {
  const Pose2 measured{0.4, 0.02, 0.1};
  const auto at = two_poses();
  const auto residuals = step_residuals(pose_of(at, 0), pose_of(at, 3), measured);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = [&](const Eigen::VectorXd& v) {
      const auto now = step_residuals(pose_of(v, 0), pose_of(v, 3), measured);
      return Eigen::VectorXd(Eigen::VectorXd::Constant(1, now[i].value));
    };
    expect_derivatives(residuals[i], test::numeric_jacobian(value, at));
  }
}

TEST(StepResiduals, VanishAtTheMeasuredStep) {
  const Pose2 first{1.0, 2.0, 3.0};
  const Pose2 step{0.4, -0.1, 0.5};
  for (const PairResidual& residual : step_residuals(first, first * step, step)) {
    EXPECT_NEAR(residual.value, 0.0, 1e-12);
  }
}

TEST(AcrossResidual, HasTheDerivativesOfItsValue) {
  const SeenWall first{0, 1.4, {0.3, 2.0}, 1.0, 0.0};
  const SeenWall second{1, -1.9, {-0.2, 1.6}, 0.8, 20.0};
  const auto at = two_poses();
  const auto value = [&](const Eigen::VectorXd& v) {
    const auto now = across_residual(pose_of(v, 0), first, pose_of(v, 3), second, 0.35);
    return Eigen::VectorXd(Eigen::VectorXd::Constant(1, now.value));
  };
  expect_derivatives(across_residual(pose_of(at, 0), first, pose_of(at, 3), second, 0.35),
                     test::numeric_jacobian(value, at));
}

/// A return of a first node's sonar, and a wall in a second node's frame, 2 m before the sonar.
struct HeardWall {
  SeenReturn seen;
  SeenWall wall;
  test::WallLine line;  ///< the wall in the map, wide
};
HeardWall heard_wall(const Pose2& first, const Pose2& second, double off_axis_rad) {
  HeardWall heard;
  heard.seen = {0, {0.15, -0.1, 0.6}, 2.1, radians(12.0), 0.0};
  const Pose2 sonar = first * heard.seen.node_from_sonar;
  const double normal_rad = sonar.theta_rad + off_axis_rad;
  const Point2 along = direction(normal_rad + kPi / 2.0);
  const Point2 middle = sonar.position() + 2.0 * direction(normal_rad) + 0.3 * along;
  heard.wall = {1, wrap_angle(normal_rad - second.theta_rad), inverse(second) * middle, 1.0, 20.0};
  heard.line = {middle - 9.0 * along, middle + 9.0 * along};
  return heard;
}

TEST(RangeResidual, HasTheDerivativesOfItsValue) {
  const auto at = two_poses();
  for (const double off_deg : {-40.0, -5.0, 3.0, 31.0}) {  // in the cone, and on either edge
    const HeardWall heard = heard_wall(pose_of(at, 0), pose_of(at, 3), radians(off_deg));
    const auto value = [&](const Eigen::VectorXd& v) {
      const auto now = range_residual(pose_of(v, 0), heard.seen, pose_of(v, 3), heard.wall);
      return Eigen::VectorXd(Eigen::VectorXd::Constant(1, now.value().value));
    };
    expect_derivatives(
        range_residual(pose_of(at, 0), heard.seen, pose_of(at, 3), heard.wall).value(),
        test::numeric_jacobian(value, at));
  }
}

TEST(RangeResidual, IsWhatTheNearestOfManyRaysIsLongerThanTheReturn) {
  const auto at = two_poses();
  for (const double off_deg : {-40.0, -5.0, 3.0, 31.0}) {
    const HeardWall heard = heard_wall(pose_of(at, 0), pose_of(at, 3), radians(off_deg));
    const double ray_m = test::cone_range({heard.line}, pose_of(at, 0) * heard.seen.node_from_sonar,
                                          heard.seen.half_cone_rad);
    EXPECT_NEAR(
        range_residual(pose_of(at, 0), heard.seen, pose_of(at, 3), heard.wall).value().value,
        ray_m - heard.seen.range_m, 1e-4);
  }
}

TEST(RangeResidual, IsNoneOfAWallBehindTheSonar) {
  const auto at = two_poses();
  const HeardWall heard = heard_wall(pose_of(at, 0), pose_of(at, 3), radians(170.0));
  EXPECT_FALSE(range_residual(pose_of(at, 0), heard.seen, pose_of(at, 3), heard.wall));
}

TEST(AcrossResidual, IsHowFarTheSecondWallLiesBehindTheFirst) {
  // both robots look along x at walls that face them; the second wall is 0.2 m farther
  const SeenWall first{0, 0.0, {2.0, 0.0}, 1.0, 0.0};
  const SeenWall second{1, 0.0, {1.2, 0.1}, 1.0, 20.0};
  EXPECT_NEAR(across_residual({0, 0, 0}, first, {1, 0, 0}, second, 0.5).value, 0.2, 1e-12);
}

TEST(RangeByHeading, IsTheDerivativeOfTheRangeToAWall) {
  const ConeLine wall{0.3, 2.5, 0.0};
  const double half_cone_rad = radians(10.0);
  constexpr double kStep = 1e-6;
  for (double axis_rad = -0.5; axis_rad < 1.1; axis_rad += 0.07) {
    const auto range_at = [&](double turn_rad) {
      return *range_to_line({{0.2, -0.1}, axis_rad + turn_rad, 0.0}, half_cone_rad, wall);
    };
    const double numeric = (range_at(kStep) - range_at(-kStep)) / (2.0 * kStep);
    const ConeReturn heard{{0.2, -0.1}, axis_rad, range_at(0.0)};
    EXPECT_NEAR(range_by_heading(heard, half_cone_rad, wall), numeric, 1e-6) << axis_rad;
  }
}

}  // namespace
}  // namespace roomatlas
