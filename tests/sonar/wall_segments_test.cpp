// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/sonar/wall_segments.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

constexpr double kHalfCone = radians(10.0);

/// A long wall at a distance from the origin, its normal in a direction.
test::WallLine wall_at(double normal_rad, double offset_m) {
  const Point2 normal = direction(normal_rad);
  const Point2 tangent(-normal.y(), normal.x());
  return {offset_m * normal - 50.0 * tangent, offset_m * normal + 50.0 * tangent};
}

TEST(RangeToLine, IsTheLeastRangeOfAllRaysInTheCone) {
  for (const double normal_deg : {0.0, 7.0, 20.0, -35.0, 60.0}) {
    const ConeLine line{radians(normal_deg), 2.0, 0.0};
    const Pose2 beam{0.3, -0.2, 0.0};
    const auto range = range_to_line({beam.position(), beam.theta_rad, 0.0}, kHalfCone, line);
    ASSERT_TRUE(range.has_value());
    EXPECT_NEAR(*range, test::cone_range({wall_at(line.normal_rad, 2.0)}, beam, kHalfCone), 2e-3)
        << normal_deg;
  }
}

TEST(RangeToLine, IsNothingForAWallBehind) {
  EXPECT_FALSE(range_to_line({{0.0, 0.0}, kPi, 0.0}, kHalfCone, {0.0, 2.0, 0.0}).has_value());
  EXPECT_FALSE(range_to_line({{3.0, 0.0}, 0.0, 0.0}, kHalfCone, {0.0, 2.0, 0.0}).has_value());
}

TEST(FitLine, FindsTheWallThatTheConeHeard) {
  for (const double normal_deg : {80.0, 95.0, 60.0, 120.0}) {
    const ConeLine wall{radians(normal_deg), 1.5, 0.0};
    std::vector<ConeReturn> returns;
    for (int k = 0; k < 12; ++k) {
      ConeReturn one{{0.08 * k, 0.0}, radians(90.0), 0.0};
      one.range_m = range_to_line(one, kHalfCone, wall).value();
      returns.push_back(one);
    }
    const auto line = fit_line(returns, kHalfCone);
    ASSERT_TRUE(line.has_value());
    EXPECT_NEAR(degrees(wrap_angle(line->normal_rad - wall.normal_rad)), 0.0, 1e-3) << normal_deg;
    EXPECT_NEAR(line->offset_m, 1.5, 1e-5);
    EXPECT_LT(line->sigma_m, 1e-5);
  }
}

TEST(FitLine, NeedsThreeReturns) {
  const std::vector<ConeReturn> two = {{{0, 0}, 0.0, 1.0}, {{0, 1}, 0.0, 1.0}};
  EXPECT_FALSE(fit_line(two, kHalfCone).has_value());
}

struct Corridor {
  std::vector<Pose2> truth = test::drive_along({{0.0, 0.0}, {6.0, 0.0}});
  std::vector<double> path_m = test::path_lengths(truth);
};

TEST(WallSegments, LieOnTheWallsAndFaceThem) {
  const Corridor corridor;
  const std::vector<test::WallLine> walls = {wall_at(radians(90.0), 1.2),
                                             wall_at(radians(-80.0), 1.0)};
  const auto readings = test::readings_along(walls, corridor.truth, 0.0);
  const auto segments = wall_segments(readings, corridor.truth, corridor.path_m, {});
  ASSERT_GE(segments.size(), 6U);
  for (const WallSegment& segment : segments) {
    const Pose2& pose = corridor.truth[segment.reading];
    const double normal_deg = degrees(wrap_angle(pose.theta_rad + segment.normal_rad));
    const bool left = normal_deg > 0.0;
    EXPECT_NEAR(normal_deg, left ? 90.0 : -80.0, 0.3);
    const Point2 middle = pose * segment.middle_robot;
    EXPECT_NEAR(direction(radians(left ? 90.0 : -80.0)).dot(middle), left ? 1.2 : 1.0, 0.01);
    EXPECT_GE(segment.length_m, WallSegmentOptions{}.min_length_m);
    EXPECT_LT(segment.sigma_m, 0.01);
  }
}

TEST(WallSegments, AreNotMadeOfScatteredReturns) {
  const Corridor corridor;
  auto readings = test::readings_along({wall_at(radians(90.0), 1.2)}, corridor.truth, 0.0);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    for (std::size_t k = 0; k < readings[i].ranges_m.size(); ++k) {
      readings[i].ranges_m[k] = 1.0F + 0.37F * static_cast<float>((i * 7 + k * 3) % 5);
    }
  }
  EXPECT_TRUE(wall_segments(readings, corridor.truth, corridor.path_m, {}).empty());
}

TEST(WallSegments, AreTheSameHoweverTheMapIsTurned) {
  const Corridor corridor;
  const auto readings = test::readings_along({wall_at(radians(85.0), 1.2)}, corridor.truth, 0.0);
  std::vector<Pose2> turned;
  for (const Pose2& pose : corridor.truth) turned.push_back(Pose2{3.0, -7.0, 2.0} * pose);
  const auto before = wall_segments(readings, corridor.truth, corridor.path_m, {});
  const auto after = wall_segments(readings, turned, corridor.path_m, {});
  ASSERT_EQ(before.size(), after.size());
  ASSERT_FALSE(before.empty());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].reading, after[i].reading);
    EXPECT_NEAR(before[i].normal_rad, after[i].normal_rad, 1e-5);
    EXPECT_NEAR((before[i].middle_robot - after[i].middle_robot).norm(), 0.0, 1e-4);
  }
}

}  // namespace
}  // namespace roomatlas
