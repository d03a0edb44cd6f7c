// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "files/bytes.hpp"
#include "roomatlas/core/geometry.hpp"

namespace roomatlas {

/// Well-known binary (OGC 06-103r4, section 8), little-endian, two dimensions. Coordinates are
/// kept bit for bit. Rings are closed in the bytes (the first vertex is repeated) and open in
/// memory. Reading throws DamagedData on another geometry type, on big-endian bytes, and on data
/// that ends early.
[[nodiscard]] Bytes wkb_of_line(const Polyline& line);                      // LineString
[[nodiscard]] Bytes wkb_of_lines(const std::vector<Polyline>& lines);       // MultiLineString
[[nodiscard]] Bytes wkb_of_polygon(const Polygon& polygon);                 // Polygon
[[nodiscard]] Bytes wkb_of_polygons(const std::vector<Polygon>& polygons);  // MultiPolygon

[[nodiscard]] Polyline line_of_wkb(ByteView wkb);
[[nodiscard]] std::vector<Polyline> lines_of_wkb(ByteView wkb);
[[nodiscard]] Polygon polygon_of_wkb(ByteView wkb);
[[nodiscard]] std::vector<Polygon> polygons_of_wkb(ByteView wkb);

/// The GeoPackage's geometry blob: its header with the bounding box, then the WKB (OGC 12-128r17,
/// section 2.1.3). An empty box marks the geometry as empty.
[[nodiscard]] Bytes geopackage_blob(const Bytes& wkb, const Box2& box, std::int32_t srs_id);
/// The WKB inside a geometry blob, with whatever bounding box another program wrote.
[[nodiscard]] ByteView wkb_of_geopackage_blob(ByteView blob);

}  // namespace roomatlas
