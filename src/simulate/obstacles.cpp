// SPDX-License-Identifier: GPL-3.0-or-later
#include "obstacles.hpp"

#include "roomatlas/simulate/world.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kBucketM = 2.0;  // side of a cell of the index; smaller visits more, larger asks
                                  // more edges in each
constexpr double kTouchM = 0.01;  // edges this near to a corner meet in it
constexpr double kLeastCornerRad = 0.6;  // turns of a curved wall are no corners

Ring normalized(Ring ring, bool counter_clockwise) {
  if ((signed_area(ring) > 0.0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
  return ring;
}

void append_edges(const Ring& ring, std::vector<Segment2>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Segment2 edge{ring[i], ring[(i + 1) % ring.size()]};
    if (edge.a != edge.b) edges.push_back(edge);
  }
}

}  // namespace

std::vector<Polygon> bodies_of(const FloorPlan& world) {
  std::vector<Polygon> bodies = world.walls;
  for (const auto& more : {outlines_of(world.furniture), open_leaves(world)}) {
    bodies.insert(bodies.end(), more.begin(), more.end());
  }
  return bodies;
}

std::vector<Segment2> edges_of(const std::vector<Polygon>& polygons) {
  std::vector<Segment2> edges;
  for (const Polygon& polygon : polygons) {
    append_edges(polygon.outer, edges);
    for (const Ring& hole : polygon.holes) append_edges(hole, edges);
  }
  return edges;
}

ObstacleIndex::Bucket ObstacleIndex::bucket_of(const Point2& point) {
  return {static_cast<int>(std::floor(point.x() / kBucketM)),
          static_cast<int>(std::floor(point.y() / kBucketM))};
}

ObstacleIndex::ObstacleIndex(const FloorPlan& world) {
  const std::vector<Polygon> bodies = bodies_of(world);
  edges_ = edges_of(bodies);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Segment2& edge = edges_[i];
    const auto [min_x, min_y] = bucket_of(edge.a.cwiseMin(edge.b));
    const auto [max_x, max_y] = bucket_of(edge.a.cwiseMax(edge.b));
    for (int x = min_x; x <= max_x; ++x) {
      for (int y = min_y; y <= max_y; ++y) {
        const Point2 middle = kBucketM * Point2(x + 0.5, y + 0.5);
        if (distance(edge, middle) <= kBucketM) buckets_[{x, y}].push_back(i);
      }
    }
  }
  for (const Polygon& body : bodies) {
    add_corners(normalized(body.outer, true));
    for (const Ring& hole : body.holes) add_corners(normalized(hole, false));
  }
}

/// @param ring with the obstacle on its left
void ObstacleIndex::add_corners(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2& at = ring[i];
    const Point2 in = at - ring[(i + ring.size() - 1) % ring.size()];
    const Point2 out = ring[(i + 1) % ring.size()] - at;
    if (std::atan2(cross(in, out), in.dot(out)) < kLeastCornerRad) continue;
    // More than its own two edges: another body leans on it, and it is no free corner.
    if (edges_near(at, kTouchM).size() == 2) corners_[bucket_of(at)].push_back(at);
  }
}

std::vector<std::size_t> ObstacleIndex::edges_near(const Point2& center, double radius_m) const {
  const auto [min_x, min_y] = bucket_of(center - Point2::Constant(radius_m));
  const auto [max_x, max_y] = bucket_of(center + Point2::Constant(radius_m));
  std::vector<std::size_t> found;
  for (int x = min_x; x <= max_x; ++x) {
    const auto end = buckets_.upper_bound({x, max_y});
    for (auto bucket = buckets_.lower_bound({x, min_y}); bucket != end; ++bucket) {
      std::copy_if(bucket->second.begin(), bucket->second.end(), std::back_inserter(found),
                   [&](std::size_t i) { return distance(edges_[i], center) <= radius_m; });
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Obstacles ObstacleIndex::within(const Point2& center, double radius_m) const {
  Obstacles near;
  for (const std::size_t i : edges_near(center, radius_m)) near.edges.push_back(edges_[i]);
  near.of_building = near.edges.size();
  const auto [min_x, min_y] = bucket_of(center - Point2::Constant(radius_m));
  const auto [max_x, max_y] = bucket_of(center + Point2::Constant(radius_m));
  for (int x = min_x; x <= max_x; ++x) {
    const auto end = corners_.upper_bound({x, max_y});
    for (auto bucket = corners_.lower_bound({x, min_y}); bucket != end; ++bucket) {
      std::copy_if(bucket->second.begin(), bucket->second.end(), std::back_inserter(near.corners),
                   [&](const Point2& at) { return (at - center).norm() <= radius_m; });
    }
  }
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
  return RayHit{range_m, std::acos(std::min(cosine, 1.0)),
                static_cast<std::size_t>(nearest - edges.data())};
}

double distance(const Segment2& first, const Segment2& second) {
  if (crossing_fraction(first, second)) return 0.0;
  return std::min({distance(first, second.a), distance(first, second.b), distance(second, first.a),
                   distance(second, first.b)});
}

}  // namespace roomatlas
