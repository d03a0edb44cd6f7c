// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/merge/regular_walls.hpp"

#include <cmath>
#include <optional>
#include <vector>

namespace roomatlas {

/// A line that edges of a ring may lie on.
struct WallLine {
  Point2 along = Point2::Zero();  ///< unit
  double offset_m = 0.0;          ///< of its points along the left normal of `along`

  [[nodiscard]] Point2 normal() const { return {-along.y(), along.x()}; }
  [[nodiscard]] double distance(const Point2& point) const {
    return std::abs(normal().dot(point) - offset_m);
  }
  [[nodiscard]] Point2 foot(const Point2& point) const {
    return point - (normal().dot(point) - offset_m) * normal();
  }
};

/// An edge that follows a direction of the building, with its line, which runs as the edge does.
struct RegularEdge {
  Segment2 evidence;
  WallLine line;
  int direction = 0;  ///< 4 a direction of the building: which way the edge runs

  [[nodiscard]] double length_m() const { return (evidence.b - evidence.a).norm(); }
};

inline constexpr double kQuarter_rad = kPi / 2.0;  ///< a right angle

/// Angle modulo a quarter turn, [0, pi/2).
[[nodiscard]] double quarter_angle(const Point2& along);

/// Signed difference modulo a quarter turn, at most an eighth turn.
[[nodiscard]] double quarter_difference(double a_rad, double b_rad);

/// The edge as one that follows a direction of the building, if it may.
[[nodiscard]] std::optional<RegularEdge> regular_edge(const Point2& a, const Point2& b,
                                                      const std::vector<double>& directions_rad,
                                                      const RegularWallOptions& options);

/// Moves lines of edges that run the same way, nearly on one line and near each other, onto one.
/// @param max_distance_m an edge's ends stay within it of the line.
/// @param max_gap_m along the line.
void align(std::vector<RegularEdge>& edges, double max_distance_m, double max_gap_m);

/// The ring whose edges lie on the given lines.
/// @param line of each edge of the ring (edge i begins in vertex i); null: it stays on its own.
/// @param max_move_m vertices do not move farther than this.
[[nodiscard]] Ring ring_on_lines(const Ring& ring, const std::vector<const WallLine*>& lines,
                                 double max_move_m);

}  // namespace roomatlas
