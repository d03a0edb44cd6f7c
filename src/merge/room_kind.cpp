// SPDX-License-Identifier: GPL-3.0-or-later
#include "room_kind.hpp"

#include "roomatlas/core/clearance.hpp"
#include "roomatlas/core/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

constexpr double kCorridorAspect = 3.0;   // length over width; less takes oblong offices for one
constexpr double kCorridorWidth_m = 3.5;  // wider is a hall or a room, however long
constexpr double kWideShare = 0.05;       // of a corridor: where corridors cross, or a lobby
constexpr double kEnclosing = 1.5;        // with holes filled, over without: a loop
constexpr double kHallArea_m2 = 80.0;     // larger rooms that are no corridors are halls
constexpr double kSameArea = 1e-6;  // of a box: a rounding must not decide which side is longer

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
    const double slack = kSameArea * area;
    if (area < smallest_area - slack || (area < smallest_area + slack && side > longest)) {
      smallest_area = std::min(area, smallest_area);
      longest = side;
    }
  }
  return longest;
}

/// How wide a shape is, sampled on a grid.
struct Width {
  double mean_m = 0.0;      ///< four times the mean clearance: the width, for a long strip
  double wide_share = 0.0;  ///< of its points, those that a corridor's width would not reach
};

Width width_of(const Polygon& polygon) {
  constexpr double kFinest_m = 0.25;  // between samples: a tenth of a corridor or so
  constexpr double kMaxSteps = 20.0;  // across a square of the polygon's area
  const double step_m = std::max(kFinest_m, std::sqrt(area(polygon)) / kMaxSteps);
  const Box2 box = bounds(polygon.outer);
  const Clearance clearance(polygon);
  double sum_m = 0.0;
  int count = 0;
  int wide = 0;
  for (double x = box.min.x() + step_m / 2.0; x < box.max.x(); x += step_m) {
    for (double y = box.min.y() + step_m / 2.0; y < box.max.y(); y += step_m) {
      const double clearance_m = clearance.at({x, y});
      if (clearance_m < 0.0) continue;
      sum_m += clearance_m;
      ++count;
      if (2.0 * clearance_m > kCorridorWidth_m) ++wide;
    }
  }
  if (count == 0) return {};
  return {4.0 * sum_m / count, static_cast<double>(wide) / count};
}

}  // namespace

RoomKind kind_of(const Polygon& largest_part, double area_m2) {
  const double part_m2 = area(largest_part);
  const double length_m = long_side(largest_part.outer);
  const bool encloses_others = std::abs(signed_area(largest_part.outer)) > kEnclosing * part_m2;
  if (encloses_others || length_m * length_m > kCorridorAspect * part_m2) {
    const Width width = width_of(largest_part);
    const bool is_long = part_m2 > kCorridorAspect * width.mean_m * width.mean_m;
    if (is_long && width.wide_share < kWideShare) return RoomKind::corridor;
  }
  return area_m2 > kHallArea_m2 ? RoomKind::hall : RoomKind::room;
}

}  // namespace roomatlas
