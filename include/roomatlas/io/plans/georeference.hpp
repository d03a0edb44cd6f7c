// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// Where a plan lies on the earth (WGS 84).
struct GeoReference {
  double latitude_deg = 0.0;   ///< of the plan's origin, [-85, 85]
  double longitude_deg = 0.0;  ///< [-180, 180]
  double heading_deg = 0.0;    ///< compass direction of the plan's y axis: 0 north, 90 east
};

struct GeoPosition {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
};

/// A point of the plan on the earth, by the radii of curvature at the plan's origin. It is off by
/// less than 2 mm at 100 m from there, and by less than 0.2 m at 1 km (up to 60 degrees of
/// latitude).
[[nodiscard]] GeoPosition position_on_earth(const GeoReference& reference, const Point2& building);

/// The plan as RFC 7946 GeoJSON in longitude and latitude with keys of OpenStreetMap's Simple
/// Indoor Tagging, 8 decimals (1 mm); one feature a line. Doors are points. Throws InputError
/// where a coordinate is not finite.
[[nodiscard]] std::string to_geojson(const FloorPlan& plan, const GeoReference& reference);

}  // namespace roomatlas
