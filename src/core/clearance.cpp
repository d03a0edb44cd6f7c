// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {

Clearance::Clearance(const Polygon& polygon) {
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 along = ring[(i + 1) % ring.size()] - ring[i];
      const double squared = along.squaredNorm();
      edges_.push_back({ring[i], along, squared > 0.0 ? 1.0 / squared : 0.0});
    }
  };
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
}

double Clearance::at(const Point2& point) const {
  double nearest = std::numeric_limits<double>::infinity();
  bool is_inside = false;
  for (const Edge& edge : edges_) {
    const Point2 to = point - edge.from;
    const double t = std::clamp(to.dot(edge.along) * edge.inverse_squared_length, 0.0, 1.0);
    nearest = std::min(nearest, (to - t * edge.along).squaredNorm());
    const bool starts_above = to.y() < 0.0;
    if (starts_above != (to.y() < edge.along.y())) {  // the edge passes the point's height
      is_inside = is_inside != ((cross(edge.along, to) > 0.0) != starts_above);
    }
  }
  return is_inside ? std::sqrt(nearest) : -std::sqrt(nearest);
}

}  // namespace roomatlas
