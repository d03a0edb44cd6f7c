// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/grid/map_cells.hpp"
#include "roomatlas/io/files/path.hpp"

namespace roomatlas {

/// Whether a file is a finished map by its ending (.yaml, .yml) or its content (PNG, PGM; also
/// gzip), not a log. False for a file that cannot be read.
[[nodiscard]] bool is_map(const Path& file);

/// Reads a finished map: a nav2 (ROS map_server) YAML file with its picture, or a bare picture,
/// whose lower left corner is the origin and whose greys are those of such maps.
/// @param resolution_m of a bare picture, metres a pixel; 0 where it is not known
/// Throws InputError naming file, line and key for what cannot be read, UsageError where the
/// resolution is missing or given twice, NotEnoughError where no cell is free.
[[nodiscard]] MapCells read_map(const Path& file, double resolution_m);

}  // namespace roomatlas
