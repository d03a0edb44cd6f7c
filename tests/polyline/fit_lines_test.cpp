// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a simplified polyline, fitted: where its vertices go.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "roomatlas/polyline/fit.hpp"

namespace roomatlas {
namespace {

using testing::ElementsAre;

constexpr double kWave = 0.03;

/// `count` points from `from` on, `step` apart, alternately kWave left and right of the line;
/// symmetric about its middle, so that the fitted line is the straight one.
void add_wall(Polyline& points, const Point2& from, const Point2& step, int count) {
  const Point2 left = Point2(-step.y(), step.x()).normalized();
  for (int i = 0; i < count; ++i) {
    const bool is_left = (i < (count + 1) / 2 ? i : count - 1 - i) % 2 == 0;
    points.push_back(from + i * step + (is_left ? kWave : -kWave) * left);
  }
}

/// Where two lines meet, by Cramer's rule on their normal forms.
Point2 cramer(const Line2& first, const Line2& second) {
  const Point2 n1(-first.unit.y(), first.unit.x());
  const Point2 n2(-second.unit.y(), second.unit.x());
  const double c1 = n1.dot(first.point);
  const double c2 = n2.dot(second.point);
  const double det = n1.x() * n2.y() - n1.y() * n2.x();
  return {(c1 * n2.y() - c2 * n1.y()) / det, (n1.x() * c2 - n2.x() * c1) / det};
}

Line2 tls(const Polyline& points, std::size_t first, std::size_t last) {
  const auto at = [&](std::size_t i) { return points.begin() + static_cast<std::ptrdiff_t>(i); };
  return fit_by_total_least_squares({at(first), at(last) + 1}, 0.07).value();
}

/// An L with its corner near (2, 0), at index 20.
Polyline l_shape() {
  Polyline points;
  add_wall(points, {0, 0}, {0.1, 0}, 21);
  add_wall(points, {2, 0.1}, {0, 0.1}, 20);
  return points;
}

TEST(FitLines, MeetInTheIntersectionOfTheLinesOfBothWalls) {
  const Polyline points = l_shape();
  const FittedPolyline fitted = fit_lines(points, {0, 20, 40}, {});
  ASSERT_EQ(fitted.vertices.size(), 3U);
  EXPECT_THAT(fitted.edge_is_fitted, ElementsAre(true, true));
  const Line2 first = tls(points, 0, 20);
  const Line2 second = tls(points, 20, 40);
  EXPECT_LT((fitted.vertices[1] - cramer(first, second)).norm(), 1e-9);
  EXPECT_LT((fitted.vertices[1] - Point2(2, 0)).norm(), 0.02);
  EXPECT_LT((fitted.vertices[0] - first.project(points[0])).norm(), 1e-9);
  EXPECT_LT((fitted.vertices[2] - second.project(points[40])).norm(), 1e-9);
}

TEST(FitLines, LieNearerToTheWallThanItsSimplifiedEdges) {
  const FittedPolyline fitted = fit_lines(l_shape(), {0, 20, 40}, {});
  EXPECT_LT(std::abs(fitted.vertices[0].y()), 0.01);
  EXPECT_NEAR(l_shape()[0].y(), kWave, 1e-12);
}

TEST(FitLines, DoNotMovePinnedVertices) {
  const Polyline points = l_shape();
  const FittedPolyline fitted = fit_lines(points, {0, 20, 40}, {}, {0, 20});
  EXPECT_EQ(fitted.vertices[0], points[0]);
  EXPECT_EQ(fitted.vertices[1], points[20]);
  EXPECT_NE(fitted.vertices[2], points[40]);
}

TEST(FitLines, MeetHalfWayWhereTheIntersectionIsTooFar) {
  const Polyline points = l_shape();
  const FittedPolyline fitted = fit_lines(points, {0, 20, 40}, {.max_corner_shift_m = 1e-4});
  const Point2 expected =
      (tls(points, 0, 20).project(points[20]) + tls(points, 20, 40).project(points[20])) / 2.0;
  EXPECT_LT((fitted.vertices[1] - expected).norm(), 1e-9);
}

TEST(FitLines, StayBesideTheWallWhereTwoEdgesAreNearlyParallel) {
  Polyline points;
  add_wall(points, {0, 0}, {0.1, 0}, 21);
  add_wall(points, {2.1, 0.01}, {0.1, 0.01}, 20);
  const FittedPolyline fitted = fit_lines(points, {0, 20, 40}, {});
  EXPECT_LT((fitted.vertices[1] - points[20]).norm(), 0.06);
}

TEST(FitLines, KeepAnEdgeWhoseFitIsRejected) {
  // A straight wall from (0, 0) to (1, 0), then a bow too round for a line.
  Polyline points;
  for (int i = 0; i <= 10; ++i) points.emplace_back(0.1 * i, 0.0);
  for (int i = 1; i <= 12; ++i) points.push_back(Point2(1, 1) + direction(radians(-90 + 15.0 * i)));
  const FittedPolyline fitted = fit_lines(points, {0, 10, 22}, {});
  EXPECT_THAT(fitted.edge_is_fitted, ElementsAre(true, false));
  EXPECT_LT((fitted.vertices[1] - Point2(1, 0)).norm(), 1e-9);
  EXPECT_EQ(fitted.vertices[2], points[22]);

  const FittedPolyline nothing = fit_lines(points, {10, 22}, {});
  EXPECT_THAT(nothing.edge_is_fitted, ElementsAre(false));
  EXPECT_EQ(nothing.vertices, (Polyline{points[10], points[22]}));
}

TEST(FitLines, KeepWallsAlongAnAxisWhenJudgedByPearson) {
  const Polyline points = l_shape();
  const FittedPolyline fitted = fit_lines(points, {0, 20, 40}, {.method = FitMethod::regression});
  EXPECT_THAT(fitted.edge_is_fitted, ElementsAre(false, false));
  EXPECT_EQ(fitted.vertices, (Polyline{points[0], points[20], points[40]}));
}

TEST(FitLines, CloseARingWithAnEdgeFromTheLastVertexToTheFirst) {
  // The square from (0, 0) to (2, 2); the last edge has points after the last vertex kept.
  Polyline points;
  add_wall(points, {0, 0}, {0.1, 0}, 20);
  add_wall(points, {2, 0}, {0, 0.1}, 20);
  add_wall(points, {2, 2}, {-0.1, 0}, 20);
  add_wall(points, {0, 2}, {0, -0.1}, 20);
  points[0] += Point2(0.03, 0.02);  // so that it matters to both of its edges
  const FittedPolyline fitted = fit_lines(points, {0, 20, 40, 60}, {}, {}, true);
  EXPECT_THAT(fitted.edge_is_fitted, ElementsAre(true, true, true, true));
  const Polyline corners = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  ASSERT_EQ(fitted.vertices.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT((fitted.vertices[i] - corners[i]).norm(), 0.03);

  Polyline last_wall(points.begin() + 60, points.end());
  last_wall.push_back(points[0]);
  const Line2 last = fit_by_total_least_squares(last_wall, 0.07).value();
  EXPECT_LT((fitted.vertices[0] - cramer(last, tls(points, 0, 20))).norm(), 1e-9);
}

TEST(FitLines, OfNothingAreNothingAndOfOneVertexThatVertex) {
  EXPECT_TRUE(fit_lines({}, {}, {}).vertices.empty());
  const FittedPolyline one = fit_lines({{1, 2}}, {0}, {});
  EXPECT_EQ(one.vertices, (Polyline{{1, 2}}));
  EXPECT_TRUE(one.edge_is_fitted.empty());
}

TEST(FitLines, MoveWithThePoints) {
  const Polyline points = l_shape();
  const Pose2 b_from_a{-3.0, 8.0, 2.0};
  const FittedPolyline here = fit_lines(points, {0, 20, 40}, {});
  const FittedPolyline there = fit_lines(transformed(b_from_a, points), {0, 20, 40}, {});
  ASSERT_EQ(there.vertices.size(), here.vertices.size());
  for (std::size_t i = 0; i < here.vertices.size(); ++i) {
    EXPECT_LT((there.vertices[i] - b_from_a * here.vertices[i]).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace roomatlas
