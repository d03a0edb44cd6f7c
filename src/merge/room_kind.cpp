// SPDX-License-Identifier: GPL-3.0-or-later
#include "room_kind.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

constexpr double kCorridorAspect = 3.0;
constexpr double kCorridorWidth_m = 3.5;
constexpr double kCorridorInnerAspect = 2.0;  // length to diameter; keeps cluttered rooms out
constexpr double kEnclosing = 1.5;            // with holes filled, over without: a loop
constexpr double kHallArea_m2 = 80.0;

/// Convex hull, counter-clockwise (Andrew's monotone chain).
Ring convex_hull(Ring points) {
  std::sort(points.begin(), points.end(), [](const Point2& a, const Point2& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  Ring hull;
  const auto add = [&](const Point2& point, std::size_t floor) {
    while (hull.size() >= floor + 2 &&
           cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(point);
  };
  for (const Point2& point : points) add(point, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto it = points.rbegin() + 1; it != points.rend(); ++it) add(*it, lower);
  hull.pop_back();
  return hull;
}

/// The longer side of the smallest oriented bounding box; of equal boxes the longest.
double long_side(const Ring& outer) {
  const Ring hull = convex_hull(outer);
  double smallest_area = std::numeric_limits<double>::infinity();
  double longest = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point2 along = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
    const Point2 across(-along.y(), along.x());
    Box2 box;
    for (const Point2& point : hull) box.extend({point.dot(along), point.dot(across)});
    const double area = box.size().prod();
    const double side = box.size().maxCoeff();
    const double slack = 1e-6 * area;
    if (area < smallest_area - slack || (area < smallest_area + slack && side > longest)) {
      smallest_area = std::min(area, smallest_area);
      longest = side;
    }
  }
  return longest;
}

double clearance(const Polygon& polygon, const Point2& point) {
  double nearest = distance_to_boundary(polygon.outer, point);
  for (const Ring& hole : polygon.holes) {
    nearest = std::min(nearest, distance_to_boundary(hole, point));
  }
  return nearest;
}

}  // namespace

const char* to_string(RoomKind kind) {
  switch (kind) {
    case RoomKind::corridor:
      return "corridor";
    case RoomKind::hall:
      return "hall";
    case RoomKind::room:
      break;
  }
  return "room";
}

RoomKind kind_of(const Polygon& largest_part, const Point2& inner, double area_m2) {
  const double part_m2 = area(largest_part);
  const double length_m = long_side(largest_part.outer);
  const double diameter_m = 2.0 * clearance(largest_part, inner);
  const bool encloses_others = std::abs(signed_area(largest_part.outer)) > kEnclosing * part_m2;
  const double aspect = length_m * length_m / part_m2;
  const double inner_aspect = part_m2 / (diameter_m * diameter_m);
  const bool is_long = (encloses_others || aspect > kCorridorAspect) &&
                       inner_aspect > (encloses_others ? kCorridorAspect : kCorridorInnerAspect);
  const bool is_narrow = std::min(part_m2 / length_m, diameter_m) < kCorridorWidth_m;
  if (is_long && is_narrow) return RoomKind::corridor;
  return area_m2 > kHallArea_m2 ? RoomKind::hall : RoomKind::room;
}

}  // namespace roomatlas
