// SPDX-License-Identifier: GPL-3.0-or-later
#include "obstacles.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

void append_edges(const Ring& ring, std::vector<Segment2>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Segment2 edge{ring[i], ring[(i + 1) % ring.size()]};
    if (edge.a != edge.b) edges.push_back(edge);
  }
}

}  // namespace

std::vector<Segment2> edges_of(const std::vector<Polygon>& polygons) {
  std::vector<Segment2> edges;
  for (const Polygon& polygon : polygons) {
    append_edges(polygon.outer, edges);
    for (const Ring& hole : polygon.holes) append_edges(hole, edges);
  }
  return edges;
}

std::vector<Segment2> obstacle_edges(const FloorPlan& world) {
  std::vector<Segment2> edges = edges_of(world.walls);
  const std::vector<Segment2> furniture = edges_of(world.furniture);
  edges.insert(edges.end(), furniture.begin(), furniture.end());
  return edges;
}

std::vector<Segment2> edges_within(const std::vector<Segment2>& edges, const Point2& center,
                                   double radius_m) {
  std::vector<Segment2> near;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(near),
               [&](const Segment2& edge) { return distance(edge, center) <= radius_m; });
  return near;
}

std::optional<RayHit> cast_ray(const std::vector<Segment2>& edges, const Point2& origin,
                               const Point2& direction, double max_range_m) {
  double range_m = max_range_m;
  const Segment2* nearest = nullptr;
  for (const Segment2& edge : edges) {
    const Point2 along = edge.b - edge.a;
    const double denominator = cross(direction, along);
    if (denominator == 0.0) continue;  // parallel
    const Point2 to_edge = edge.a - origin;
    const double t = cross(to_edge, along) / denominator;
    if (t < 0.0 || t >= range_m) continue;
    const double u = cross(to_edge, direction) / denominator;
    if (u < 0.0 || u > 1.0) continue;
    range_m = t;
    nearest = &edge;
  }
  if (nearest == nullptr) return std::nullopt;
  const Point2 along = nearest->b - nearest->a;
  const double cosine = std::abs(cross(direction, along)) / along.norm();
  return RayHit{range_m, std::acos(std::min(cosine, 1.0))};
}

double distance(const Segment2& first, const Segment2& second) {
  if (crossing_fraction(first, second)) return 0.0;
  return std::min({distance(first, second.a), distance(first, second.b), distance(second, first.a),
                   distance(second, first.b)});
}

}  // namespace roomatlas
