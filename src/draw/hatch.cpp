// SPDX-License-Identifier: GPL-3.0-or-later
#include "hatch.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::drawing {

std::vector<Segment2> hatched(const Polygon& polygon_mm, double angle_rad, double pitch_mm) {
  constexpr int kMostLines = 20000;  // of one body: a plan's size that went wrong
  const Point2 along(std::cos(angle_rad), -std::sin(angle_rad));  // y is down on paper
  const Point2 across(-along.y(), along.x());
  std::vector<Segment2> edges;
  double low = 1e300;
  double high = -1e300;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2& a = ring[i];
      const Point2& b = ring[(i + 1) % ring.size()];
      edges.push_back({{along.dot(a), across.dot(a)}, {along.dot(b), across.dot(b)}});
      low = std::min(low, across.dot(a));
      high = std::max(high, across.dot(a));
    }
  };
  add(polygon_mm.outer);
  for (const Ring& hole : polygon_mm.holes) add(hole);
  std::vector<Segment2> lines;
  if (!(high > low) || (high - low) / pitch_mm > kMostLines) return lines;
  for (double v = (std::floor(low / pitch_mm) + 0.5) * pitch_mm; v < high; v += pitch_mm) {
    std::vector<double> crossings;
    for (const Segment2& edge : edges) {
      if ((edge.a.y() <= v) == (edge.b.y() <= v)) continue;
      const double share = (v - edge.a.y()) / (edge.b.y() - edge.a.y());
      crossings.push_back(edge.a.x() + share * (edge.b.x() - edge.a.x()));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      lines.push_back({crossings[i] * along + v * across, crossings[i + 1] * along + v * across});
    }
  }
  return lines;
}

}  // namespace roomatlas::drawing
