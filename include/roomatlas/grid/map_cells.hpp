// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "roomatlas/grid/raster.hpp"

namespace roomatlas {

/// What a finished map says of one cell.
enum class MapCell : std::uint8_t { unknown, free, occupied };

/// A finished occupancy map of whatever program.
struct MapCells {
  CellFrame frame;  ///< the map's own: cell (0, 0) lies at its lower left corner
  Raster<MapCell> cells;
  Pose2 building_from_map;  ///< where that corner is, and how the map is turned
};

}  // namespace roomatlas
