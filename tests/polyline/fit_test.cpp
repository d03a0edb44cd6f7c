// SPDX-License-Identifier: GPL-3.0-or-later
// One line through points: regression and total least squares.
#include "roomatlas/polyline/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace roomatlas {
namespace {

Polyline noisy_line(std::mt19937& random, const Point2& from, double heading_rad, int count,
                    double noise_m) {
  std::normal_distribution<double> noise(0.0, noise_m);
  Polyline points;
  for (int i = 0; i < count; ++i) {
    points.push_back(from + 0.1 * i * direction(heading_rad) +
                     Point2(noise(random), noise(random)));
  }
  return points;
}

/// Angle between two undirected lines, [0, pi/2].
double angle_between(const Point2& a, const Point2& b) {
  return std::atan2(std::abs(cross(a, b)), std::abs(a.dot(b)));
}

double distance_to(const Line2& line, const Point2& point) {
  return (line.project(point) - point).norm();
}

struct Regression {
  double b0 = 0.0;
  double b1 = 0.0;
  double rho = 0.0;
};

/// Equations (4) to (6) with the plain sums of the paper.
Regression equations_4_to_6(const Polyline& points) {
  const auto n = static_cast<double>(points.size());
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (const Point2& p : points) {
    x += p.x();
    y += p.y();
    xx += p.x() * p.x();
    xy += p.x() * p.y();
    yy += p.y() * p.y();
  }
  Regression line;
  line.b1 = (n * xy - x * y) / (n * xx - x * x);
  line.b0 = y / n - line.b1 * x / n;
  line.rho = (n * xy - x * y) / std::sqrt((n * xx - x * x) * (n * yy - y * y));
  return line;
}

TEST(FitByRegression, IsTheLineOfEquations4To6) {
  std::mt19937 random(41);
  int accepted = 0;
  for (int round = 0; round < 200; ++round) {
    const Polyline points = noisy_line(random, {3, -2}, 0.05 * round, 3 + round % 20, 0.05);
    const Regression expected = equations_4_to_6(points);
    const auto line = fit_by_regression(points, 0.9);
    ASSERT_EQ(line.has_value(), std::abs(expected.rho) >= 0.9) << expected.rho;
    if (!line) continue;
    ++accepted;
    EXPECT_NEAR(line->unit.y() / line->unit.x(), expected.b1, 1e-6 * (1 + std::abs(expected.b1)));
    EXPECT_NEAR(line->point.y(), expected.b0 + expected.b1 * line->point.x(), 1e-6);
    EXPECT_NEAR(line->unit.norm(), 1.0, 1e-12);
  }
  EXPECT_GT(accepted, 100);
  EXPECT_LT(accepted, 200);
}

TEST(FitByRegression, AcceptsFallingWallsAsWellAsRisingOnes) {
  EXPECT_TRUE(fit_by_regression({{0, 0}, {1, 1.1}, {2, 1.9}}, 0.9).has_value());
  EXPECT_TRUE(fit_by_regression({{0, 0}, {1, -1.1}, {2, -1.9}}, 0.9).has_value());
}

TEST(FitLine, OfWallsAlongAnAxisIsRejectedByPearsonAndAcceptedByTotalLeastSquares) {
  std::mt19937 random(42);
  for (const double noise_m : {0.0, 0.02}) {
    for (const double heading_rad : {0.0, kPi / 2.0}) {
      const Polyline wall = noisy_line(random, {0.1, 0.3}, heading_rad, 30, noise_m + 1e-15);
      EXPECT_FALSE(fit_by_regression(wall, 0.9).has_value());
      const auto line = fit_by_total_least_squares(wall, 0.07);
      ASSERT_TRUE(line.has_value());
      EXPECT_LT(angle_between(line->unit, direction(heading_rad)), 0.02);
    }
  }
  EXPECT_FALSE(fit_by_regression({{0.1, 0}, {0.1, 1}, {0.1, 2}}, 0.9).has_value());
  EXPECT_FALSE(fit_by_regression({{0, 0.1}, {1, 0.1}, {2, 0.1}}, 0.9).has_value());
}

double squared_error(const Polyline& points, const Point2& mean, double angle_rad) {
  double sum = 0.0;
  for (const Point2& p : points) sum += std::pow(cross(direction(angle_rad), p - mean), 2);
  return sum;
}

TEST(FitByTotalLeastSquares, FindsTheLineOfASearchOverAllAngles) {
  std::mt19937 random(43);
  constexpr int kAngles = 18000;
  for (const double heading_rad : {0.0, 0.4, 1.2, kPi / 2.0, 2.3, 3.0}) {
    const Polyline points = noisy_line(random, {-4, 9}, heading_rad, 15, 0.1);
    Point2 mean = Point2::Zero();
    for (const Point2& p : points) mean += p / static_cast<double>(points.size());
    double best_rad = 0.0;
    for (int i = 1; i < kAngles; ++i) {
      const double angle_rad = kPi * i / kAngles;
      if (squared_error(points, mean, angle_rad) < squared_error(points, mean, best_rad)) {
        best_rad = angle_rad;
      }
    }
    const auto line = fit_by_total_least_squares(points, 1.0);
    ASSERT_TRUE(line.has_value());
    EXPECT_LT(angle_between(line->unit, direction(best_rad)), kPi / kAngles);
    EXPECT_LT(distance_to(*line, mean), 1e-12);
  }
}

TEST(FitByTotalLeastSquares, TurnsWithThePoints) {
  std::mt19937 random(44);
  const Polyline points = noisy_line(random, {1, 2}, 0.2, 20, 0.05);
  const auto line = fit_by_total_least_squares(points, 0.07);
  ASSERT_TRUE(line.has_value());
  for (int i = 0; i < 36; ++i) {
    const Pose2 b_from_a{5.0, -3.0, radians(10.0 * i)};
    const auto turned = fit_by_total_least_squares(transformed(b_from_a, points), 0.07);
    ASSERT_TRUE(turned.has_value());
    EXPECT_LT(distance_to(*turned, b_from_a * line->point), 1e-9);
    EXPECT_LT(distance_to(*turned, b_from_a * Point2(line->point + line->unit)), 1e-9);
  }
}

TEST(FitByTotalLeastSquares, AcceptsUpToTheStandardDeviationAcrossTheLine) {
  // Alternately 0.06 left and right of y = x: the standard deviation is 0.06.
  Polyline points;
  for (int i = 0; i < 40; ++i) {
    const double across_m = (i % 4 == 0 || i % 4 == 3) ? 0.06 : -0.06;
    points.push_back(0.2 * i * direction(kPi / 4.0) + across_m * direction(3.0 * kPi / 4.0));
  }
  EXPECT_TRUE(fit_by_total_least_squares(points, 0.0601).has_value());
  EXPECT_FALSE(fit_by_total_least_squares(points, 0.0599).has_value());
}

TEST(FitLine, NeedsTwoDistinctPoints) {
  for (const std::size_t count : {0U, 1U, 2U, 3U, 7U}) {
    const Polyline same(count, Point2(0.1, 0.7));
    EXPECT_FALSE(fit_by_regression(same, 0.9).has_value()) << count;
    EXPECT_FALSE(fit_by_total_least_squares(same, 0.07).has_value()) << count;
  }
  EXPECT_TRUE(fit_by_regression({{0, 0}, {1, 2}}, 0.9).has_value());
  EXPECT_TRUE(fit_by_total_least_squares({{0, 0}, {0, 2}}, 0.07).has_value());
}

}  // namespace
}  // namespace roomatlas
