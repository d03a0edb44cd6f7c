// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/bare_floor.hpp"

namespace roomatlas {

/// Of each face, whether it is a wall's for certain where sonars heard it: much of it was heard,
/// or both sides of the wall, or it runs from one such wall to another with no floor between.
/// Sides of tables and boxes end on the floor, however many of them happen to share a line.
[[nodiscard]] std::vector<bool> sonar_walls(const Walls& walls, const Occupancy& occupancy,
                                            const BareFloorOptions& options);

}  // namespace roomatlas
