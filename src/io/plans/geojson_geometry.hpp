// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"
#include "text/json_field.hpp"

#include <string>
#include <vector>

namespace roomatlas {

/// Of any coordinate: what a building, or a map of the earth in metres, has.
inline constexpr double kFarthest_m = 1e8;

/// Rounds to the millimetre, the resolution of a plan file. Throws InputError where not finite.
[[nodiscard]] double to_millimetre(double value_m);
[[nodiscard]] Point2 to_millimetre(const Point2& point_m);

[[nodiscard]] Json to_json(const Point2& point);
[[nodiscard]] Point2 read_position(const JsonField& position);

/// GeoJSON Polygon or MultiPolygon geometry. Rings are closed and wound as RFC 7946 asks (outer
/// rings counter-clockwise); rings that collapse when rounded to the millimetre are left out.
/// One polygon gives a Polygon, another number a MultiPolygon.
[[nodiscard]] Json to_geometry(const std::vector<Polygon>& polygons);
/// The same, but null where nothing is left of the ring.
[[nodiscard]] Json to_geometry(const Ring& ring);

/// A LineString from end to end; null where both ends are one when rounded.
[[nodiscard]] Json to_geometry(const Segment2& line);

/// Its two ends. Throws InputError unless it is a LineString of two positions.
[[nodiscard]] Segment2 read_segment(const JsonField& geometry);
/// The polygons of a feature's geometry, wound as above. Throws InputError unless it is a Polygon
/// or MultiPolygon of closed rings of at least three different points.
[[nodiscard]] std::vector<Polygon> read_polygons(const JsonField& geometry);
/// The same, where one Polygon is expected.
[[nodiscard]] Polygon read_polygon(const JsonField& geometry);

/// Where the label of a part that was read stands: well inside it, by a thousandth of its extent,
/// since a file's shapes may be of any.
[[nodiscard]] Point2 label_point_in(const Polygon& part);

}  // namespace roomatlas
