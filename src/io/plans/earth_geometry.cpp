// SPDX-License-Identifier: GPL-3.0-or-later
#include "earth_geometry.hpp"

#include <cmath>

#include "text/json.hpp"

namespace roomatlas {
namespace {

double rounded(double value_deg) { return std::round(value_deg * 1e8) / 1e8 + 0.0; }

/// Coordinates of any depth.
Json coordinates_on_earth(const GeoReference& reference, const Json& coordinates) {
  if (!coordinates.empty() && coordinates[0].is_number()) {
    return position_json(reference, {coordinates[0].get<double>(), coordinates[1].get<double>()});
  }
  Json result = Json::array();
  for (const Json& inner : coordinates) result.push_back(coordinates_on_earth(reference, inner));
  return result;
}

}  // namespace

Json position_json(const GeoReference& reference, const Point2& building) {
  const GeoPosition at = position_on_earth(reference, building);
  return Json::array({rounded(at.longitude_deg), rounded(at.latitude_deg)});
}

Json on_earth(const GeoReference& reference, Json geometry) {
  if (geometry.is_null()) return geometry;
  geometry["coordinates"] = coordinates_on_earth(reference, geometry["coordinates"]);
  return geometry;
}

}  // namespace roomatlas
