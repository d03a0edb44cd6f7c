// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <array>
#include <utility>
#include <vector>

/// The planar map behind `merge`. Private: all coordinates are millimetres on a local grid.
namespace roomatlas::planar {

/// A triangle and what lies beyond each of its edges. Edge i is opposite to corner i and runs
/// from corner i + 1 to corner i + 2 (modulo 3), so the triangle lies on its left.
struct Triangle {
  std::array<int, 3> corner{};
  std::array<int, 3> neighbor{};  ///< -1 beyond the convex hull
  std::array<bool, 3> is_constrained{};
};

/// A triangulation of the convex hull of its points; every triangle is counter-clockwise.
struct TriangleMesh {
  std::vector<Point2> points_mm;
  std::vector<Triangle> triangles;
};

/// Constrained Delaunay triangulation of points and of edges between them. Edges may cross,
/// overlap and repeat: crossings become points of the mesh. They are computed exactly: with
/// rounded ones CGAL 5.5 silently lost edges in 3 of 100 random inputs where several edges meet
/// in one point, which no check of the result short of a second computation would have noticed.
/// Fewer than three points, or points on one line, give a mesh without triangles.
/// @param points_mm distinct.
/// @param edges pairs of different indices of points.
[[nodiscard]] TriangleMesh triangulate(const std::vector<Point2>& points_mm,
                                       const std::vector<std::pair<int, int>>& edges);

}  // namespace roomatlas::planar
