// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"

#include <optional>
#include <vector>

namespace roomatlas {

using Polyline = std::vector<Point2>;  ///< open chain of vertices
using Ring = std::vector<Point2>;      ///< closed chain; the first vertex is not repeated

/// Outer ring (counter-clockwise after `normalized`) and holes (clockwise). Values are not
/// checked: rings may self-intersect until `merge` has healed them.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

struct Segment2 {
  Point2 a = Point2::Zero();
  Point2 b = Point2::Zero();
};

/// Empty until it is extended: its bounds are then beyond any coordinate.
struct Box2 {
  Point2 min = Point2::Constant(1e300);
  Point2 max = Point2::Constant(-1e300);

  [[nodiscard]] bool empty() const { return min.x() > max.x() || min.y() > max.y(); }
  void extend(const Point2& point);
  [[nodiscard]] Point2 size() const { return empty() ? Point2::Zero() : Point2(max - min); }
};

[[nodiscard]] double cross(const Point2& a, const Point2& b);

/// Signed area in square metres (shoelace); positive for a counter-clockwise ring, 0 when empty.
[[nodiscard]] double signed_area(const Ring& ring);
/// Area in square metres of the outer ring less its holes, whatever their orientation.
[[nodiscard]] double area(const Polygon& polygon);
[[nodiscard]] double length(const Polyline& line);
/// Even-odd test; points on an edge may go either way. False for an empty ring.
[[nodiscard]] bool contains(const Ring& ring, const Point2& point);
/// Whether a ray from the point along +x crosses the segment: an odd number of a ring's edges where
/// the ring contains the point.
[[nodiscard]] bool is_crossed_by_ray(const Segment2& segment, const Point2& point);
[[nodiscard]] bool contains(const Polygon& polygon, const Point2& point);

[[nodiscard]] double distance(const Segment2& segment, const Point2& point);
/// Distance to the ring's boundary, in metres; infinity for an empty ring.
[[nodiscard]] double distance_to_boundary(const Ring& ring, const Point2& point);
/// Where two segments cross, as the fraction along `first`; nothing when parallel or apart.
[[nodiscard]] std::optional<double> crossing_fraction(const Segment2& first,
                                                      const Segment2& second);

/// A point well inside the polygon: the centre of the largest circle that a search to
/// `precision_m` finds (quad-tree search after V. Agafonkin's "polylabel", 2016). For an empty
/// polygon the origin.
[[nodiscard]] Point2 interior_point(const Polygon& polygon, double precision_m = 0.05);

[[nodiscard]] Box2 bounds(const Ring& ring);

[[nodiscard]] Polyline transformed(const Pose2& a_from_b, const Polyline& line_b);
[[nodiscard]] Polygon transformed(const Pose2& a_from_b, const Polygon& polygon_b);
[[nodiscard]] Segment2 transformed(const Pose2& a_from_b, const Segment2& segment_b);
[[nodiscard]] Segment2 transformed(const PointTransform& a_from_b, const Segment2& segment_b);

}  // namespace roomatlas
