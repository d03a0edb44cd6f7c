// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef ROOMATLAS_GDAL

#include "ogr_geometry.hpp"

#include "ogr_memory.hpp"
#include "roomatlas/core/issue.hpp"

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

}  // namespace

OGRLineString to_ogr(const Polyline& line) { return curve_of<OGRLineString>(line); }

OGRLineString closed_line(const Ring& ring) {
  auto line = curve_of<OGRLineString>(ring);
  if (!ring.empty()) line.addPoint(ring.front().x(), ring.front().y());
  return line;
}

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

void add(OGRLayer& layer, OGRFeature& feature, const OGRGeometry& shape) {
  if (feature.SetGeometry(&shape) != OGRERR_NONE || layer.CreateFeature(&feature) != OGRERR_NONE) {
    throw InputError(last_error());
  }
}

}  // namespace roomatlas::ogr

#endif
