// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/merge/merge.hpp"

#include <numeric>
#include <vector>

namespace roomatlas::test {

inline Ring rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline double total_area(const std::vector<Polygon>& polygons) {
  double sum = 0.0;
  for (const Polygon& polygon : polygons) sum += area(polygon);
  return sum;
}

inline bool contains_any(const std::vector<Polygon>& polygons, const Point2& point) {
  for (const Polygon& polygon : polygons) {
    if (contains(polygon, point)) return true;
  }
  return false;
}

}  // namespace roomatlas::test
