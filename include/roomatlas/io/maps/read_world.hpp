// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/io/files/path.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

struct WorldFileOptions {
  double resolution_m = 0.0;  ///< of a bare picture, metres a pixel; 0 where it is not known
  Path room_labels;           ///< picture with the room's number for each pixel; empty for none
};

/// A world to drive through: a plan as GeoJSON, a nav2 map (YAML, with its picture), or a bare
/// picture (PNG, PGM; also gzip) with its resolution; told by ending and content. The lower left
/// corner of a bare picture is the origin. What was assumed about a picture is in the plan's
/// issues (docs/formats.md). Throws InputError for what cannot be read, UsageError for options
/// that do not fit the file.
[[nodiscard]] FloorPlan read_world(const Path& file, const WorldFileOptions& options);

}  // namespace roomatlas
