// SPDX-License-Identifier: GPL-3.0-or-later
#include "extent.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace roomatlas::changes {
namespace {

constexpr int kStep_deg = 3;

Extent extent_along(const std::vector<Point2>& points, const Point2& along, double margin_m) {
  Box2 box;
  for (const Point2& point : points) box.extend({along.dot(point), cross(along, point)});
  const Point2 middle = (box.min + box.max) / 2.0;
  const Point2 across(-along.y(), along.x());
  Extent extent{middle.x() * along + middle.y() * across, along, box.size().x() + 2.0 * margin_m,
                box.size().y() + 2.0 * margin_m};
  if (extent.length_m < extent.width_m) {
    std::swap(extent.length_m, extent.width_m);
    extent.along = across;
  }
  return extent;
}

}  // namespace

Extent extent_of(const std::vector<Point2>& points, double margin_m) {
  Extent best;
  if (points.empty()) return best;
  double least_m2 = std::numeric_limits<double>::infinity();
  for (int deg = 0; deg < 90; deg += kStep_deg) {
    const Extent extent = extent_along(points, direction(radians(deg)), margin_m);
    const double area_m2 = extent.length_m * (extent.width_m + 1e-3);  // thin ones by their length
    if (area_m2 >= least_m2) continue;
    least_m2 = area_m2;
    best = extent;
  }
  return best;
}

Ring ring_of(const Extent& extent) {
  const Point2 half_length = extent.length_m / 2.0 * extent.along;
  const Point2 half_width = extent.width_m / 2.0 * extent.across();
  return {extent.middle - half_length - half_width, extent.middle + half_length - half_width,
          extent.middle + half_length + half_width, extent.middle - half_length + half_width};
}

double distance_m(const Polygon& polygon, const Point2& point) {
  if (contains(polygon, point)) return 0.0;
  double nearest_m = distance_to_boundary(polygon.outer, point);
  for (const Ring& hole : polygon.holes) {
    nearest_m = std::min(nearest_m, distance_to_boundary(hole, point));
  }
  return nearest_m;
}

}  // namespace roomatlas::changes
