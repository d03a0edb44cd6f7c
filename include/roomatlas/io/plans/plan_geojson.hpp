// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/io/files/path.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// The plan as GeoJSON in local metres, and back (docs/formats.md has the attribute schema).
/// Reading throws InputError naming the feature and property at fault.
[[nodiscard]] std::string to_geojson(const FloorPlan& plan);
[[nodiscard]] FloorPlan read_plan(const Path& file);

}  // namespace roomatlas
