// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/sonar/wall_headings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/false_loops.hpp"

namespace roomatlas {
namespace {

/// Returns of a sonar that drives along a wall, and the line through them.
ConeLine heard_along(double length_m, double sigma_m, test::Dice& dice) {
  constexpr double kStepM = 0.05;
  constexpr double kHalfCone = radians(10.0);
  const ConeLine wall{kPi / 2.0, 1.5, 0.0};
  std::vector<ConeReturn> returns;
  for (double x_m = 0.0; x_m <= length_m; x_m += kStepM) {
    ConeReturn one{{x_m, 0.0}, kPi / 2.0, 0.0};
    one.range_m = range_to_line(one, kHalfCone, wall).value() + sigma_m * dice.normal();
    returns.push_back(one);
  }
  return fit_line(returns, kHalfCone).value();
}

/// By many walls that are heard.
double turned_rad(double length_m, double sigma_m) {
  constexpr int kWalls = 400;
  test::Dice dice(11);
  double squares = 0.0;
  for (int i = 0; i < kWalls; ++i) {
    squares += std::pow(heard_along(length_m, sigma_m, dice).normal_rad - kPi / 2.0, 2);
  }
  return std::sqrt(squares / kWalls);
}

/// Sigma of a direction at the solution, without what walls have that are ever so long.
double by_scatter_rad(double length_m, double sigma_m, SonarBatchOptions options) {
  options.is_settled = true;
  options.settled_heading_rad = 0.0;
  SeenWall wall;
  wall.length_m = length_m;
  wall.sigma_m = sigma_m;
  const double share = options.settled_heading_weight * std::min(1.0, length_m);
  return std::sqrt(share / heading_information(wall, options));
}

TEST(HeadingInformation, FallsWithScatterAndLengthAsALinesDirectionDoes) {
  for (const double length_m : {0.6, 1.0, 2.0}) {
    for (const double sigma_m : {0.01, 0.02}) {
      const double ratio = by_scatter_rad(length_m, sigma_m, {}) / turned_rad(length_m, sigma_m);
      EXPECT_NEAR(ratio, 2.6, 0.4) << length_m << " m, " << sigma_m;
    }
  }
}

TEST(HeadingInformation, OfLongStraightWallsIsFarMoreAtTheSolutionAndOfShortRoughOnesLess) {
  SonarBatchOptions settled;
  settled.is_settled = true;
  SeenWall wall;
  wall.length_m = 1.8;
  wall.sigma_m = 0.008;
  EXPECT_GT(heading_information(wall, settled), 5.0 * heading_information(wall, {}));
  wall.length_m = 0.45;
  wall.sigma_m = 0.025;
  EXPECT_LT(heading_information(wall, settled), heading_information(wall, {}));
}

TEST(HeadingInformation, IsNoneWhereWallsFollowNoDirection) {
  SonarBatchOptions free;
  free.is_settled = true;
  free.settled_heading_weight = 0.0;
  SeenWall wall;
  wall.length_m = 1.0;
  EXPECT_EQ(heading_information(wall, free), 0.0);
}

}  // namespace
}  // namespace roomatlas
