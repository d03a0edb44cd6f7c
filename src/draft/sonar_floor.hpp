// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/walls.hpp"
#include "roomatlas/rooms/building_grid.hpp"

namespace roomatlas {

/// Makes floor of the furniture in the cells on which sonars' rooms are decided, and obstacles of
/// walls that are known.
/// @param is_wall parallel to the faces: which are walls for certain
/// @param bare the floor without furniture
void take_furniture_out(const Walls& walls, const std::vector<bool>& is_wall,
                        const Occupancy& occupancy, const Occupancy& bare, BuildingGrid& grid);

/// The share of the obstacles that were heard that is on no wall: how furnished a building is.
[[nodiscard]] double share_on_no_wall(const Walls& walls, const std::vector<bool>& is_wall,
                                      const BuildingGrid& heard);

/// Tells the grid's passable cells again: free, and connected to the path.
/// @param margin_m from obstacles, as the grid was made with
void find_passable(const std::vector<Pose2>& path, double margin_m, BuildingGrid& grid);

/// Makes an obstacle of what is left open between the jambs of an opening and the walls beside it.
void close_beside(const Segment2& jambs, double most_m, BuildingGrid& grid);

/// Follows the obstacles that were heard beside an opening, along its line as far as they go, and
/// lets them stand: a wall that follows no direction of the building has no faces.
void restore_beside(const Segment2& jambs, const BuildingGrid& heard, BuildingGrid& grid);

}  // namespace roomatlas
