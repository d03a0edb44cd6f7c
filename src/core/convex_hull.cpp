// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/convex_hull.hpp"

#include <algorithm>

namespace roomatlas {

Ring convex_hull(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(), [](const Point2& a, const Point2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Ring ring;
  const auto add = [&](const Point2& point, std::size_t fixed) {
    while (ring.size() > fixed &&
           cross(ring.back() - ring[ring.size() - 2], point - ring.back()) <= 0.0) {
      ring.pop_back();
    }
    ring.push_back(point);
  };
  for (const Point2& point : points) add(point, 1);  // along the lower side
  const std::size_t lower = ring.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  ring.pop_back();  // the first point again
  return ring;
}

}  // namespace roomatlas
