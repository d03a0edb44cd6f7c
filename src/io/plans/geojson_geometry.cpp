// SPDX-License-Identifier: GPL-3.0-or-later
#include "geojson_geometry.hpp"

#include "roomatlas/core/issue.hpp"
#include "text/json.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

/// Keeps the first vertex first.
Ring wound(Ring ring, bool counter_clockwise) {
  const double area_m2 = signed_area(ring);
  if (counter_clockwise ? area_m2 < 0.0 : area_m2 > 0.0) {
    std::reverse(ring.begin() + 1, ring.end());
  }
  return ring;
}

/// Rounded, without repeated points; empty where fewer than three are left.
Ring rounded(const Ring& ring) {
  Ring kept;
  for (const Point2& point : ring) {
    const Point2 corner(to_millimetre(point.x()), to_millimetre(point.y()));
    if (kept.empty() || kept.back() != corner) kept.push_back(corner);
  }
  while (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
  return kept.size() < 3 ? Ring{} : kept;
}

Json ring_coordinates(const Ring& ring, bool counter_clockwise) {
  Json coordinates = Json::array();
  for (const Point2& point : wound(ring, counter_clockwise)) coordinates.push_back(to_json(point));
  coordinates.push_back(coordinates.front());
  return coordinates;
}

/// Empty where nothing is left of the outer ring.
Json polygon_coordinates(const Polygon& polygon) {
  Json coordinates = Json::array();
  const Ring outer = rounded(polygon.outer);
  if (outer.empty()) return coordinates;
  coordinates.push_back(ring_coordinates(outer, true));
  for (const Ring& hole : polygon.holes) {
    const Ring inner = rounded(hole);
    if (!inner.empty()) coordinates.push_back(ring_coordinates(inner, false));
  }
  return coordinates;
}

Json geometry_of(const char* type, Json coordinates) {
  Json geometry;
  geometry["type"] = type;
  geometry["coordinates"] = std::move(coordinates);
  return geometry;
}

Ring read_ring(const JsonField& coordinates, bool counter_clockwise) {
  Ring ring;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const Point2 point = read_position(coordinates.element(i));
    if (ring.empty() || ring.back() != point) ring.push_back(point);
  }
  if (coordinates.size() < 2 || ring.back() != ring.front()) {
    coordinates.fail("a closed ring, its first position repeated at the end");
  }
  ring.pop_back();
  if (ring.size() < 3) coordinates.fail("a ring of at least three different positions");
  return wound(std::move(ring), counter_clockwise);
}

Polygon read_rings(const JsonField& rings) {
  if (rings.size() == 0) rings.fail("a polygon of at least one ring");
  Polygon polygon{read_ring(rings.element(0), true), {}};
  for (std::size_t i = 1; i < rings.size(); ++i) {
    polygon.holes.push_back(read_ring(rings.element(i), false));
  }
  return polygon;
}

}  // namespace

double to_millimetre(double value_m) {
  if (!std::isfinite(value_m)) throw InputError("plan: a coordinate or size is not finite");
  return std::round(value_m * 1000.0) / 1000.0 + 0.0;  // + 0.0 turns -0 into 0
}

Point2 to_millimetre(const Point2& point_m) {
  return {to_millimetre(point_m.x()), to_millimetre(point_m.y())};
}

Json to_json(const Point2& point) {
  return Json::array({to_millimetre(point.x()), to_millimetre(point.y())});
}

Point2 read_position(const JsonField& position) {
  if (position.size() < 2) position.fail("a position [x, y]");
  Point2 point(position.element(0).number(), position.element(1).number());
  if (point.cwiseAbs().maxCoeff() > kFarthest_m) position.fail("a place within 100,000 km");
  return point;
}

Json to_geometry(const std::vector<Polygon>& polygons) {
  Json several = Json::array();
  for (const Polygon& polygon : polygons) {
    Json coordinates = polygon_coordinates(polygon);
    if (!coordinates.empty()) several.push_back(std::move(coordinates));
  }
  if (several.size() == 1) return geometry_of("Polygon", several.front());
  return geometry_of("MultiPolygon", std::move(several));
}

Json to_geometry(const Ring& ring) {
  Json coordinates = polygon_coordinates({ring, {}});
  return coordinates.empty() ? Json(nullptr) : geometry_of("Polygon", std::move(coordinates));
}

Json to_geometry(const Segment2& line) {
  const Json from = to_json(line.a);
  const Json to = to_json(line.b);
  return from == to ? Json(nullptr) : geometry_of("LineString", Json::array({from, to}));
}

Segment2 read_segment(const JsonField& geometry) {
  if (geometry.at("type").text() != "LineString") geometry.at("type").fail("\"LineString\"");
  const JsonField ends = geometry.at("coordinates");
  if (ends.size() != 2) ends.fail("two positions");
  return {read_position(ends.element(0)), read_position(ends.element(1))};
}

std::vector<Polygon> read_polygons(const JsonField& geometry) {
  const JsonField type = geometry.at("type");
  const JsonField coordinates = geometry.at("coordinates");
  if (type.text() == "Polygon") return {read_rings(coordinates)};
  if (type.text() != "MultiPolygon") type.fail("\"Polygon\" or \"MultiPolygon\"");
  std::vector<Polygon> polygons;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    polygons.push_back(read_rings(coordinates.element(i)));
  }
  return polygons;
}

Polygon read_polygon(const JsonField& geometry) {
  if (geometry.at("type").text() != "Polygon") geometry.at("type").fail("\"Polygon\"");
  return read_rings(geometry.at("coordinates"));
}

Point2 label_point_in(const Polygon& part) {
  constexpr double kFinest_m = 0.05;  // what nobody sees a label off
  constexpr double kOfExtent = 1e-3;
  const Box2 box = bounds(part.outer);
  const double extent_m = box.empty() ? 0.0 : box.size().maxCoeff();
  return interior_point(part, std::max(kFinest_m, kOfExtent * extent_m));
}

}  // namespace roomatlas
