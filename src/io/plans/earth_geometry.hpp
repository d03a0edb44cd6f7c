// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/io/plans/georeference.hpp"
#include "text/json_fwd.hpp"

/// GeoJSON geometries from building metres to longitude and latitude. Private.
namespace roomatlas {

/// [longitude, latitude], 8 decimals.
[[nodiscard]] Json position_json(const GeoReference& reference, const Point2& building);

/// A geometry of any type that is in building metres; null stays null.
[[nodiscard]] Json on_earth(const GeoReference& reference, Json geometry);

}  // namespace roomatlas
