// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

/// Calls `visit(a, b)` for each edge of a ring, the closing one included.
template <typename Visit>
void for_each_edge(const Ring& ring, Visit visit) {
  for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
}

}  // namespace

void Box2::extend(const Point2& point) {
  min = min.cwiseMin(point);
  max = max.cwiseMax(point);
}

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

double signed_area(const Ring& ring) {
  if (ring.empty()) return 0.0;
  const Point2& origin = ring.front();  // near the ring, so that large coordinates keep precision
  double doubled = 0.0;
  for_each_edge(
      ring, [&](const Point2& a, const Point2& b) { doubled += cross(a - origin, b - origin); });
  return doubled / 2.0;
}

double area(const Polygon& polygon) {
  double sum = std::abs(signed_area(polygon.outer));
  for (const Ring& hole : polygon.holes) sum -= std::abs(signed_area(hole));
  return sum;
}

double length(const Polyline& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

bool is_crossed_by_ray(const Segment2& segment, const Point2& point) {
  const auto& [a, b] = segment;
  if ((a.y() > point.y()) == (b.y() > point.y())) return false;
  return point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
}

bool contains(const Ring& ring, const Point2& point) {
  bool inside = false;
  for_each_edge(ring, [&](const Point2& a, const Point2& b) {
    if (is_crossed_by_ray({a, b}, point)) inside = !inside;
  });
  return inside;
}

bool contains(const Polygon& polygon, const Point2& point) {
  return contains(polygon.outer, point) &&
         std::none_of(polygon.holes.begin(), polygon.holes.end(),
                      [&](const Ring& hole) { return contains(hole, point); });
}

double distance(const Segment2& segment, const Point2& point) {
  const Point2 along = segment.b - segment.a;
  const double squared = along.squaredNorm();
  const double t =
      squared > 0.0 ? std::clamp((point - segment.a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (segment.a + t * along - point).norm();
}

double distance_to_boundary(const Ring& ring, const Point2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for_each_edge(ring, [&](const Point2& a, const Point2& b) {
    nearest = std::min(nearest, distance(Segment2{a, b}, point));
  });
  return nearest;
}

std::optional<double> crossing_fraction(const Segment2& first, const Segment2& second) {
  const Point2 r = first.b - first.a;
  const Point2 s = second.b - second.a;
  const double denominator = cross(r, s);
  if (denominator == 0.0) return std::nullopt;
  const double t = cross(second.a - first.a, s) / denominator;
  const double u = cross(second.a - first.a, r) / denominator;
  if (t < 0.0 || t > 1.0 || u < 0.0 || u > 1.0) return std::nullopt;
  return t;
}

Box2 bounds(const Ring& ring) {
  Box2 box;
  for (const Point2& point : ring) box.extend(point);
  return box;
}

Polyline transformed(const Pose2& a_from_b, const Polyline& line_b) {
  Polyline line_a;
  line_a.reserve(line_b.size());
  for (const Point2& point : line_b) line_a.push_back(a_from_b * point);
  return line_a;
}

Polygon transformed(const Pose2& a_from_b, const Polygon& polygon_b) {
  Polygon polygon_a;
  polygon_a.outer = transformed(a_from_b, polygon_b.outer);
  for (const Ring& hole : polygon_b.holes) polygon_a.holes.push_back(transformed(a_from_b, hole));
  return polygon_a;
}

Segment2 transformed(const Pose2& a_from_b, const Segment2& segment_b) {
  return transformed(PointTransform(a_from_b), segment_b);
}

Segment2 transformed(const PointTransform& a_from_b, const Segment2& segment_b) {
  return {a_from_b * segment_b.a, a_from_b * segment_b.b};
}

}  // namespace roomatlas
