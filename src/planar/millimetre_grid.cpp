// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/planar/millimetre_grid.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::planar {
namespace {

constexpr double kMillimetres = 1000.0;  // in a metre
constexpr double kEarthRadius_m = 1e7;   // rounded up
constexpr int kBits = 50;  // of a double's 53 that a coordinate takes; more would round differences
constexpr int kCoarsest = 16;  // 2^-16 mm: as far away as the Earth is large
constexpr int kFinest = 34;    // 2^-34 mm: finer than anything needs

Ring on_grid(const MillimetreGrid& grid, const Ring& ring_m, Dropped& dropped) {
  Ring ring_mm;
  ring_mm.reserve(ring_m.size());
  for (const Point2& point : ring_m) {
    if (!is_plausible(point)) {
      ++dropped.implausible;
      continue;
    }
    const Point2 point_mm = grid.to_grid(point);
    if (!ring_mm.empty() && ring_mm.back() == point_mm) {
      ++dropped.repeated;
    } else {
      ring_mm.push_back(point_mm);
    }
  }
  while (ring_mm.size() > 1 && ring_mm.front() == ring_mm.back()) {
    ++dropped.repeated;
    ring_mm.pop_back();
  }
  return ring_mm;
}

template <typename Change>
Polygon with_each_ring(const Polygon& polygon, Change change) {
  Polygon changed;
  changed.outer = change(polygon.outer);
  for (const Ring& hole : polygon.holes) changed.holes.push_back(change(hole));
  return changed;
}

}  // namespace

MillimetreGrid::MillimetreGrid(const Box2& around) {
  if (around.empty()) return;
  origin_mm_ = {std::floor(around.min.x()) * kMillimetres,
                std::floor(around.min.y()) * kMillimetres};
  const double reach_mm =
      std::max({1.0, around.min.cwiseAbs().maxCoeff(), around.max.cwiseAbs().maxCoeff()}) *
      kMillimetres;
  fine_ = std::exp2(std::clamp(kBits - std::ilogb(reach_mm) - 1, kCoarsest, kFinest));
}

Point2 MillimetreGrid::to_grid(const Point2& point) const {
  return {std::round(point.x() * kMillimetres) - origin_mm_.x(),
          std::round(point.y() * kMillimetres) - origin_mm_.y()};
}

Point2 MillimetreGrid::to_metres(const Point2& point_mm) const {
  return (point_mm + origin_mm_) / kMillimetres;
}

Ring MillimetreGrid::to_metres(const Ring& ring_mm) const {
  Ring ring_m;
  ring_m.reserve(ring_mm.size());
  for (const Point2& point : ring_mm) ring_m.push_back(to_metres(point));
  return ring_m;
}

std::vector<Polygon> MillimetreGrid::to_metres(const std::vector<Polygon>& polygons_mm) const {
  std::vector<Polygon> polygons_m;
  polygons_m.reserve(polygons_mm.size());
  for (const Polygon& polygon : polygons_mm) {
    polygons_m.push_back(
        with_each_ring(polygon, [&](const Ring& ring) { return to_metres(ring); }));
  }
  return polygons_m;
}

bool is_plausible(const Point2& point_m) {
  return std::abs(point_m.x()) < kEarthRadius_m && std::abs(point_m.y()) < kEarthRadius_m;
}

Polygon on_grid(const MillimetreGrid& grid, const Polygon& polygon_m, Dropped* dropped) {
  Dropped counted;
  Polygon polygon_mm =
      with_each_ring(polygon_m, [&](const Ring& ring) { return on_grid(grid, ring, counted); });
  if (dropped != nullptr) *dropped = counted;
  return polygon_mm;
}

void extend(Box2& box, const Polygon& polygon_m) {
  for (const Point2& point : polygon_m.outer) {
    if (is_plausible(point)) box.extend(point);
  }
  for (const Ring& hole : polygon_m.holes) {
    for (const Point2& point : hole) {
      if (is_plausible(point)) box.extend(point);
    }
  }
}

Ring rounded(const Ring& ring_mm) {
  Ring ring;
  for (const Point2& point : ring_mm) {
    const Point2 whole(std::round(point.x()), std::round(point.y()));
    if (ring.empty() || ring.back() != whole) ring.push_back(whole);
  }
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

Polygon rounded(const Polygon& polygon_mm) {
  return with_each_ring(polygon_mm, [](const Ring& ring) { return rounded(ring); });
}

}  // namespace roomatlas::planar
