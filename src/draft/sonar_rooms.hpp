// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/draft/draft_building.hpp"

namespace roomatlas {

/// Rooms of what sonars heard, after furniture has been taken out of the cells. Where most of what
/// was heard is walls, the shape of the floor tells them, as with lasers; in a furnished building
/// where the robot drove does, and only openings in walls part them.
[[nodiscard]] RoomPartition sonar_rooms(const Walls& walls, const Occupancy& occupancy,
                                        const BuildingEvidence& evidence,
                                        const DraftBuildingOptions& options);

}  // namespace roomatlas
