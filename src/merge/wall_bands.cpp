// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_bands.hpp"

#include "grid.hpp"

namespace roomatlas::planar {
namespace {

constexpr double kSharpestCosine = -0.2;  // between outward normals: a turn of about 100 degrees

Point2 outward(const Point2& along) { return {along.y(), -along.x()}; }

/// The piece outside of a convex corner, between the ends of its two edges' rectangles.
Ring corner_piece(const Point2& corner, const Point2& in, const Point2& out, double thickness) {
  const Point2 from = outward(in);
  const Point2 to = outward(out);
  const double cosine = from.dot(to);
  if (cosine > kSharpestCosine) {
    const Point2 tip = (from + to) / (1.0 + cosine);
    return {corner, corner + from * thickness, corner + tip * thickness, corner + to * thickness};
  }
  return {corner, corner + from * thickness, corner + (from + in) * thickness,
          corner + (to - out) * thickness, corner + to * thickness};
}

void add_bands(const Ring& ring, double thickness, std::vector<Polygon>& bands) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2& a = ring[i];
    const Point2& b = ring[(i + 1) % ring.size()];
    const Point2& c = ring[(i + 2) % ring.size()];
    const Point2 in = (b - a).normalized();
    const Point2 out = (c - b).normalized();
    const Point2 aside = outward(in) * thickness;
    bands.push_back({rounded({a, a + aside, b + aside, b}), {}});
    const double turn = cross(in, out);
    if (turn > 0.0 || (turn == 0.0 && in.dot(out) < 0.0)) {
      bands.push_back({rounded(corner_piece(b, in, out, thickness)), {}});
    }
  }
}

}  // namespace

std::vector<Polygon> wall_bands(const Polygon& polygon_mm, double thickness_mm) {
  std::vector<Polygon> bands;
  if (!(thickness_mm > 0.0)) return bands;
  add_bands(polygon_mm.outer, thickness_mm, bands);
  for (const Ring& hole : polygon_mm.holes) add_bands(hole, thickness_mm, bands);
  return bands;
}

}  // namespace roomatlas::planar
