// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace roomatlas {

/// All that a robot may run into: walls, furniture, leaves of doors that stand open, in this order.
[[nodiscard]] std::vector<Polygon> bodies_of(const FloorPlan& world);

/// All edges of some polygons, those of holes included and those of no length left out.
[[nodiscard]] std::vector<Segment2> edges_of(const std::vector<Polygon>& polygons);

/// What stops a beam.
struct Obstacles {
  std::vector<Segment2> edges;
  std::size_t of_building = 0;  ///< the first so many edges do not move
  std::vector<Point2> corners;  ///< convex ones that stand free, such as door jambs
};

/// The walls, furniture and open leaves of a world in square buckets, so that what is near a point
/// is found without looking at the whole building. Casting the rays of one sweep against these few
/// costs less than walking a grid does at the ranges of a sonar.
class ObstacleIndex {
 public:
  explicit ObstacleIndex(const FloorPlan& world);
  /// What comes within `radius_m` of a point, in the order of the world.
  [[nodiscard]] Obstacles within(const Point2& center, double radius_m) const;

 private:
  using Bucket = std::pair<int, int>;
  [[nodiscard]] static Bucket bucket_of(const Point2& point);
  [[nodiscard]] std::vector<std::size_t> edges_near(const Point2& center, double radius_m) const;
  void add_corners(const Ring& ring);

  std::vector<Segment2> edges_;
  std::map<Bucket, std::vector<std::size_t>> buckets_;
  std::map<Bucket, std::vector<Point2>> corners_;
};

/// Where a ray first meets an edge.
struct RayHit {
  double range_m = 0.0;
  double incidence_rad = 0.0;  ///< from the edge's normal, [0, pi/2]
  std::size_t edge = 0;        ///< its place in the list
};

/// @param direction a unit vector
/// Nothing when no edge is met before `max_range_m`.
[[nodiscard]] std::optional<RayHit> cast_ray(const std::vector<Segment2>& edges,
                                             const Point2& origin, const Point2& direction,
                                             double max_range_m);

/// Least distance between two segments, in metres; 0 where they touch or cross.
[[nodiscard]] double distance(const Segment2& first, const Segment2& second);

}  // namespace roomatlas
