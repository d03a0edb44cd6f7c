// SPDX-License-Identifier: GPL-3.0-or-later
#include "ogr_geometry.hpp"

namespace roomatlas::ogr {
namespace {

template <typename Curve>
Curve curve_of(const std::vector<Point2>& points) {
  Curve curve;
  for (const Point2& point : points) curve.addPoint(point.x(), point.y());
  return curve;
}

OGRLinearRing ring_of(const Ring& ring) {
  auto closed = curve_of<OGRLinearRing>(ring);
  closed.closeRings();
  return closed;
}

OGRPoint to_ogr(const Point2& point) { return {point.x(), point.y()}; }

OGRLineString to_ogr(const Polyline& line) { return curve_of<OGRLineString>(line); }

OGRPolygon to_ogr(const Polygon& polygon) {
  OGRPolygon shape;
  OGRLinearRing outer = ring_of(polygon.outer);
  shape.addRing(&outer);
  for (const Ring& hole : polygon.holes) {
    OGRLinearRing inner = ring_of(hole);
    shape.addRing(&inner);
  }
  return shape;
}

OGRMultiPolygon to_ogr(const std::vector<Polygon>& polygons) {
  OGRMultiPolygon shape;
  for (const Polygon& polygon : polygons) {
    const OGRPolygon part = to_ogr(polygon);
    shape.addGeometry(&part);
  }
  return shape;
}

}  // namespace

std::unique_ptr<OGRGeometry> to_ogr(const io::VectorShape& shape) {
  return std::visit(
      [](const auto& own) -> std::unique_ptr<OGRGeometry> {
        return std::unique_ptr<OGRGeometry>(to_ogr(own).clone());
      },
      shape);
}

}  // namespace roomatlas::ogr
