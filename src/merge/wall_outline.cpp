// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_outline.hpp"

#include <algorithm>

namespace roomatlas::planar {
namespace {

constexpr double kSharpestCosine = -0.2;  // between outward normals: a turn of about 100 degrees

Point2 outward(const Point2& along) { return {along.y(), -along.x()}; }

/// A corner of a ring: directions of the edges that meet there, and the length of the shorter.
struct Corner {
  Point2 at;
  Point2 in;
  Point2 out;
  double shorter_mm = 0.0;
};

/// Appends what the offset ring does around the corner.
void turn(const Corner& corner, double thickness, Ring& ring) {
  const Point2 from = outward(corner.in);
  const Point2 to = outward(corner.out);
  const double cosine = from.dot(to);
  const double sine = cross(corner.in, corner.out);
  const Point2 tip = (from + to) / (1.0 + cosine);
  if (sine > 0.0 || cosine <= -1.0) {  // convex
    if (cosine > kSharpestCosine) {
      ring.push_back(corner.at + tip * thickness);
    } else {
      ring.push_back(corner.at + (from + corner.in) * thickness);
      ring.push_back(corner.at + (to - corner.out) * thickness);
    }
    return;
  }
  const double step_back = thickness * -sine / (1.0 + cosine);
  if (2.0 * step_back < corner.shorter_mm) {
    ring.push_back(corner.at + tip * thickness);
  } else {  // the edge is too short: by the corner itself, which makes a loop that winds rightly
    ring.push_back(corner.at + from * thickness);
    ring.push_back(corner.at);
    ring.push_back(corner.at + to * thickness);
  }
}

Ring offset(const Ring& ring, double thickness) {
  Ring moved;
  const std::size_t count = ring.size();
  if (count < 3) return moved;
  for (std::size_t i = 0; i < count; ++i) {
    const Point2 in = ring[i] - ring[(i + count - 1) % count];
    const Point2 out = ring[(i + 1) % count] - ring[i];
    turn({ring[i], in.normalized(), out.normalized(), std::min(in.norm(), out.norm())}, thickness,
         moved);
  }
  return moved;
}

}  // namespace

Polygon wall_outline(const Polygon& polygon_mm, double thickness_mm) {
  Polygon moved{offset(polygon_mm.outer, thickness_mm), {}};
  for (const Ring& hole : polygon_mm.holes) moved.holes.push_back(offset(hole, thickness_mm));
  return moved;
}

}  // namespace roomatlas::planar
