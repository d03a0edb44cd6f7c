// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/merge/regular_walls.hpp"

#include <map>
#include <vector>

namespace roomatlas {

using RingsOfRooms = std::map<RoomId, std::vector<Ring*>>;

[[nodiscard]] RingsOfRooms rings_of(std::vector<PlacedOutline>& outlines);

/// Turns a door about its middle into the wall beside it, where one follows a direction of the
/// building; vertices of the rooms' rings that are its jambs go with it.
void turn_into_wall(Door& door, const RingsOfRooms& rings,
                    const std::vector<double>& directions_rad, const RegularWallOptions& options);

}  // namespace roomatlas
