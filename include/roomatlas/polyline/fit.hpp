// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "roomatlas/core/geometry.hpp"

namespace roomatlas {

enum class FitMethod {
  total_least_squares,  ///< judged by the residual; the same for every direction
  regression,           ///< the paper's y = b0 + b1 x, judged by Pearson's rho
};

struct FitOptions {
  FitMethod method = FitMethod::total_least_squares;
  double max_sigma_m = 0.07;        ///< 0.7 cell. Larger straightens curved walls
  double min_abs_rho = 0.9;         ///< paper III.E; |rho| because walls may fall as well as rise
  double max_corner_shift_m = 0.4;  ///< a corner may move this far to where its lines meet
};

struct Line2 {
  Point2 point = Point2::Zero();
  Point2 unit = Point2::UnitX();

  [[nodiscard]] Point2 project(const Point2& p) const { return point + unit * unit.dot(p - point); }
};

/// Line by regression, equations (4) and (5), accepted when |rho| of equation (6) is at least
/// `min_abs_rho`. Walls parallel to an axis are rejected: (4) divides by zero, or rho tends to 0.
/// Nothing for fewer than two distinct points.
[[nodiscard]] std::optional<Line2> fit_by_regression(const Polyline& points, double min_abs_rho);

/// Line by total least squares (smallest eigenvector of the scatter matrix), accepted when the
/// standard deviation of the points across it is at most `max_sigma_m`. Nothing for fewer than
/// two distinct points.
[[nodiscard]] std::optional<Line2> fit_by_total_least_squares(const Polyline& points,
                                                              double max_sigma_m);

struct FittedPolyline {
  Polyline vertices;
  std::vector<bool> edge_is_fitted;  ///< one an edge; false: the Douglas-Peucker edge was kept
};

/// Fits each edge of a simplified polyline to the points it stands for (paper III.E). A rejected
/// fit keeps the edge. Neighbouring fitted lines meet in their corner where that is near; a
/// vertex beside one fitted line is projected on it. Pinned vertices do not move.
/// @param kept ascending indices of the vertices in `points`, the ends included
/// @param pinned indices of `points` that keep their place
/// @param closed joins the last vertex to the first with an edge of its own (points after the
///   last kept one belong to it); the first kept index must then be 0
[[nodiscard]] FittedPolyline fit_lines(const Polyline& points, const std::vector<std::size_t>& kept,
                                       const FitOptions& options,
                                       const std::vector<std::size_t>& pinned = {},
                                       bool closed = false);

}  // namespace roomatlas
