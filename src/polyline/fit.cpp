// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/fit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

using MaybeLine = std::optional<Line2>;

Point2 mean_of(const Polyline& points) {
  Point2 sum = Point2::Zero();
  for (const Point2& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

/// Asked of the points themselves: sums about a rounded mean are not quite zero for equal points.
bool has_distinct_points(const Polyline& points) {
  return std::any_of(points.begin(), points.end(),
                     [&](const Point2& point) { return point != points.front(); });
}

MaybeLine fit(const Polyline& points, const FitOptions& options) {
  return options.method == FitMethod::regression
             ? fit_by_regression(points, options.min_abs_rho)
             : fit_by_total_least_squares(points, options.max_sigma_m);
}

/// Where two lines meet, if they are not nearly parallel.
std::optional<Point2> meeting_point(const Line2& first, const Line2& second) {
  constexpr double kMinSine = 0.25;  // about 15 degrees: flatter corners are ill defined
  const double sine = cross(first.unit, second.unit);
  if (std::abs(sine) < kMinSine) return std::nullopt;
  const double along = cross(second.point - first.point, second.unit) / sine;
  return first.point + along * first.unit;
}

/// The place of a vertex between the lines of its two edges, either of which may be missing.
Point2 corner(const Point2& vertex, const MaybeLine& before, const MaybeLine& after,
              double max_shift_m) {
  if (!before && !after) return vertex;
  if (!before) return after->project(vertex);
  if (!after) return before->project(vertex);
  const std::optional<Point2> meeting = meeting_point(*before, *after);
  if (meeting && (*meeting - vertex).norm() <= max_shift_m) return *meeting;
  return (before->project(vertex) + after->project(vertex)) / 2.0;
}

/// The points an edge stands for: from its first kept vertex to its second, around the end of a
/// closed chain where `end` is before `begin`.
Polyline span_of(const Polyline& points, std::size_t begin, std::size_t end) {
  const auto at = [&](std::size_t i) { return points.begin() + static_cast<std::ptrdiff_t>(i); };
  if (end > begin) return {at(begin), at(end) + 1};
  Polyline span(at(begin), points.end());
  span.insert(span.end(), points.begin(), at(end) + 1);
  return span;
}

}  // namespace

MaybeLine fit_by_regression(const Polyline& points, double min_abs_rho) {
  if (!has_distinct_points(points)) return std::nullopt;
  const Point2 mean = mean_of(points);
  // Sums about the mean: the same b1 and rho as (4) and (6) without losing digits.
  double sxx = 0.0;
  double sxy = 0.0;
  double syy = 0.0;
  for (const Point2& point : points) {
    const Point2 offset = point - mean;
    sxx += offset.x() * offset.x();
    sxy += offset.x() * offset.y();
    syy += offset.y() * offset.y();
  }
  if (sxx <= 0.0 || syy <= 0.0) return std::nullopt;
  const double b1 = sxy / sxx;                    // (4)
  const double b0 = mean.y() - b1 * mean.x();     // (5)
  const double rho = sxy / std::sqrt(sxx * syy);  // (6)
  if (!(std::abs(rho) >= min_abs_rho)) return std::nullopt;
  return Line2{{mean.x(), b0 + b1 * mean.x()}, Point2(1.0, b1).normalized()};
}

MaybeLine fit_by_total_least_squares(const Polyline& points, double max_sigma_m) {
  if (!has_distinct_points(points)) return std::nullopt;
  const Point2 mean = mean_of(points);
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Point2& point : points) scatter += (point - mean) * (point - mean).transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(scatter);
  if (solver.eigenvalues()(1) <= 0.0) return std::nullopt;
  const double variance =
      std::max(0.0, solver.eigenvalues()(0)) / static_cast<double>(points.size());
  if (std::sqrt(variance) > max_sigma_m) return std::nullopt;
  return Line2{mean, solver.eigenvectors().col(1)};
}

FittedPolyline fit_lines(const Polyline& points, const std::vector<std::size_t>& kept,
                         const FitOptions& options, const std::vector<std::size_t>& pinned,
                         bool closed) {
  FittedPolyline result;
  if (kept.empty()) return result;
  const std::size_t edges = closed ? kept.size() : kept.size() - 1;
  std::vector<MaybeLine> lines;
  for (std::size_t e = 0; e < edges; ++e) {
    lines.push_back(fit(span_of(points, kept[e], kept[(e + 1) % kept.size()]), options));
    result.edge_is_fitted.push_back(lines.back().has_value());
  }
  for (std::size_t v = 0; v < kept.size(); ++v) {
    const bool has_before = closed || v > 0;
    const bool has_after = v < edges;
    const MaybeLine before = has_before ? lines[(v + edges - 1) % edges] : std::nullopt;
    const MaybeLine after = has_after ? lines[v] : std::nullopt;
    const bool is_pinned = std::binary_search(pinned.begin(), pinned.end(), kept[v]);
    result.vertices.push_back(
        is_pinned ? points[kept[v]]
                  : corner(points[kept[v]], before, after, options.max_corner_shift_m));
  }
  return result;
}

}  // namespace roomatlas
