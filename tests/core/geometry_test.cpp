// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/geometry.hpp"

#include <gtest/gtest.h>

namespace roomatlas {
namespace {

const Ring kUnitSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(Geometry, AreaOfAPolygonLeavesItsHolesOut) {
  const Polygon polygon{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}};
  EXPECT_DOUBLE_EQ(area(polygon), 11.0);
  EXPECT_DOUBLE_EQ(signed_area(kUnitSquare), 1.0);
  EXPECT_DOUBLE_EQ(signed_area({{0, 0}, {0, 1}, {1, 1}, {1, 0}}), -1.0);
  EXPECT_DOUBLE_EQ(signed_area({}), 0.0);
}

TEST(Geometry, ContainsSeesHoles) {
  const Polygon polygon{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}};
  EXPECT_TRUE(contains(polygon, Point2(0.5, 0.5)));
  EXPECT_FALSE(contains(polygon, Point2(1.5, 1.5)));
  EXPECT_FALSE(contains(polygon, Point2(5.0, 1.0)));
}

TEST(Geometry, CrossingFractionIsMeasuredAlongTheFirstSegment) {
  const auto t = crossing_fraction({{0, 0}, {4, 0}}, {{1, -1}, {1, 1}});
  ASSERT_TRUE(t.has_value());
  EXPECT_DOUBLE_EQ(*t, 0.25);
  EXPECT_FALSE(crossing_fraction({{0, 0}, {4, 0}}, {{0, 1}, {4, 1}}).has_value());
  EXPECT_FALSE(crossing_fraction({{0, 0}, {4, 0}}, {{5, -1}, {5, 1}}).has_value());
}

TEST(Geometry, InteriorPointOfAnLShapeLiesInsideUnlikeItsCentroid) {
  const Polygon shape{{{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}}, {}};
  const Point2 point = interior_point(shape);
  EXPECT_TRUE(contains(shape, point));
  EXPECT_GT(distance_to_boundary(shape.outer, point), 0.45);
}

TEST(Geometry, InteriorPointAgreesWithAFineSearch) {
  const Polygon shape{{{0, 0}, {6, 0.5}, {5, 4}, {2, 3}, {1, 5}},
                      {{{2, 1}, {2, 2}, {3, 2}, {3, 1}}}};
  const auto clearance = [&](const Point2& p) {
    return std::min(distance_to_boundary(shape.outer, p), distance_to_boundary(shape.holes[0], p));
  };
  double best = 0.0;
  for (double x = 0.0; x < 6.0; x += 0.02) {
    for (double y = 0.0; y < 5.0; y += 0.02) {
      if (contains(shape, Point2(x, y))) best = std::max(best, clearance({x, y}));
    }
  }
  EXPECT_NEAR(clearance(interior_point(shape, 0.01)), best, 0.03);
}

}  // namespace
}  // namespace roomatlas
