// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/convex_hull.hpp"

#include <gtest/gtest.h>

#include <random>

namespace roomatlas {
namespace {

TEST(ConvexHull, HoldsAllPointsAndTurnsLeft) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-5.0, 5.0);
  std::vector<Point2> points;
  for (int i = 0; i < 200; ++i) points.emplace_back(coordinate(random), coordinate(random));
  const Ring hull = convex_hull(points);
  ASSERT_GE(hull.size(), 3U);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point2& from = hull[i];
    const Point2 way = hull[(i + 1) % hull.size()] - from;
    EXPECT_GT(cross(way, hull[(i + 2) % hull.size()] - from), 0.0);
    for (const Point2& point : points) EXPECT_GE(cross(way, point - from), -1e-12);
  }
}

TEST(ConvexHull, OfPointsOnALineHasNoArea) {
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_NEAR(signed_area(convex_hull({{0, 0}, {1, 1}, {2, 2}, {3, 3}})), 0.0, 1e-12);
}

}  // namespace
}  // namespace roomatlas
