// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/draft/draft_building.hpp"

namespace roomatlas {

/// Rooms of what sonars heard, by where the robot drove. Furniture is taken out of the cells first,
/// and only openings in walls part rooms.
[[nodiscard]] RoomPartition sonar_rooms(const Walls& walls, const Occupancy& occupancy,
                                        const BuildingEvidence& evidence,
                                        const DraftBuildingOptions& options);

}  // namespace roomatlas
