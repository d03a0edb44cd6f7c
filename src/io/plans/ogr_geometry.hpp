// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ogrsf_frmts.h>

#include <vector>

#include "roomatlas/core/geometry.hpp"

/// Our shapes as those of OGR. Private; included in builds with GDAL alone.
namespace roomatlas::ogr {

[[nodiscard]] OGRLineString to_ogr(const Polyline& line);
/// Closed: the first point stands again at the end.
[[nodiscard]] OGRLineString closed_line(const Ring& ring);
[[nodiscard]] OGRPolygon to_ogr(const Polygon& polygon);
[[nodiscard]] OGRMultiPolygon to_ogr(const std::vector<Polygon>& polygons);

/// Writes the feature with a copy of the shape. Throws InputError.
void add(OGRLayer& layer, OGRFeature& feature, const OGRGeometry& shape);

}  // namespace roomatlas::ogr
