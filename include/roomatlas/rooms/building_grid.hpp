// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/grid/reflection_map.hpp"
#include "roomatlas/polyline/region.hpp"

namespace roomatlas {

struct BuildingGridOptions {
  double cell_m = 0.1;           ///< smaller cells need more beams each; a wall is one cell or more
  double occupied_share = 0.25;  ///< reflected share from which a cell is an obstacle; higher
                                 ///< loses glass and walls met at flat angles
  double sonar_occupied_share = 0.2;  ///< the same where sonars saw it: their cones blur walls
  int min_hits = 2;                   ///< fewer are noise
  int min_passes = 2;                 ///< a cell passed less often is not known to be free
  int min_obstacle_cells = 4;         ///< smaller groups of obstacles are people or noise
  double margin_m = 0.1;              ///< passable cells have at least this much free around them
};

/// What a whole mission saw, decided cell by cell, building metres. The masks share one domain.
struct BuildingGrid {
  CellFrame frame;
  CellMask free{CellBox{}};      ///< seen, and no obstacle; where the robot stood always
  CellMask obstacle{CellBox{}};  ///< walls, furniture
  CellMask passable{CellBox{}};  ///< free with a margin, and connected to the path that way
};

/// @param kind of the sensors that made the map; sonar where there were both
/// @param building_from_robot the mission's path
/// @param footprint what the robot stood on is free
[[nodiscard]] BuildingGrid building_grid(const ReflectionMap& map, SensorKind kind,
                                         const std::vector<Pose2>& building_from_robot,
                                         const RobotFootprint& footprint,
                                         const BuildingGridOptions& options);

}  // namespace roomatlas
