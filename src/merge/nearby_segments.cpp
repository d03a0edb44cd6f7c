// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearby_segments.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

std::int64_t key_of(double column, double row) {
  constexpr std::int64_t kStride = std::int64_t{1} << 32;  // more than there are rows
  return static_cast<std::int64_t>(column) * kStride + static_cast<std::int64_t>(row);
}

}  // namespace

/// A long segment is kept in pieces of at most half a cell, each in the cell of its middle: what
/// comes near to a point is then in the cells around it.
void NearbySegments::add(const Segment2& segment) {
  if (!segment.a.allFinite() || !segment.b.allFinite()) return;
  const Point2 along = segment.b - segment.a;
  const int pieces = std::max(1, static_cast<int>(std::ceil(along.norm() / (kCell_m / 2.0))));
  for (int i = 0; i < pieces; ++i) {
    const Segment2 piece{segment.a + along * (static_cast<double>(i) / pieces),
                         segment.a + along * (static_cast<double>(i + 1) / pieces)};
    const Point2 middle = (piece.a + piece.b) / (2.0 * kCell_m);
    cells_[key_of(std::floor(middle.x()), std::floor(middle.y()))].push_back(piece);
  }
}

void NearbySegments::add_line(const Polyline& line) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) add({line[i], line[i + 1]});
}

void NearbySegments::add_ring(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) add({ring[i], ring[(i + 1) % ring.size()]});
}

template <typename Test>
bool NearbySegments::any_around(const Point2& point, Test test) const {
  const double column = std::floor(point.x() / kCell_m);
  const double row = std::floor(point.y() / kCell_m);
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      const auto cell = cells_.find(key_of(column + i, row + j));
      if (cell == cells_.end()) continue;
      if (std::any_of(cell->second.begin(), cell->second.end(), test)) return true;
    }
  }
  return false;
}

bool NearbySegments::is_near(const Point2& point, double reach_m) const {
  return any_around(point,
                    [&](const Segment2& segment) { return distance(segment, point) <= reach_m; });
}

bool NearbySegments::crosses(const Segment2& probe) const {
  return any_around((probe.a + probe.b) / 2.0, [&](const Segment2& segment) {
    const auto at = crossing_fraction(probe, segment);
    return at && *at >= 0.0 && *at <= 1.0;
  });
}

}  // namespace roomatlas
