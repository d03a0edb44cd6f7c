// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/io/files/path.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// A plan from any GeoJSON: one of this program as `read_plan` reads it, else rooms as other
/// programs write them (QGIS, OpenStreetMap's indoor tags; docs/formats.md). Polygons are rooms,
/// in metres or in longitude and latitude, which are laid out in metres east and north of their
/// middle. Doors are points or lines that say so. Where the file has no walls, thin ones are put
/// along the rooms' edges, open where the doors are. What was assumed, and how much was left out,
/// is in the plan's issues. Throws InputError naming the feature at fault, and for a file without
/// rooms, of several levels, or in Web Mercator.
[[nodiscard]] FloorPlan read_any_plan(const Path& file);

}  // namespace roomatlas
