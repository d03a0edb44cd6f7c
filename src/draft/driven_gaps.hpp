// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/walls.hpp"

namespace roomatlas {

/// Gaps in walls that the robot drove through, jamb to jamb; the narrowest first. A door may have
/// one in each face of its wall.
/// @param is_wall parallel to the faces: which are walls for certain
[[nodiscard]] std::vector<Segment2> driven_gaps(const Walls& walls,
                                                const std::vector<bool>& is_wall,
                                                const std::vector<Pose2>& path);

/// The faces without what stands where a door in such a gap swings: nothing stands there but its
/// leaf, which sonars hear as a wall, at any angle.
[[nodiscard]] std::vector<WallFace> without_swings(const Walls& walls,
                                                   const std::vector<bool>& is_wall,
                                                   const std::vector<Segment2>& gaps);

/// The same of cells: what stands there and is no wall becomes floor.
void clear_swings(const Walls& walls, const std::vector<bool>& is_wall,
                  const std::vector<Segment2>& gaps, Occupancy& occupancy);

}  // namespace roomatlas
