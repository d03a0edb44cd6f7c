// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/draft/walls.hpp"

namespace roomatlas {

struct BareFloorOptions {
  double min_prominence_m = 2.5;   ///< of a line that is a wall's; less takes cupboards for walls
  double min_hidden_m = 1.0;       ///< the same of one that goes on behind furniture
  double thin_m = 0.25;            ///< between two faces: a wall, however short ...
  double min_thin_m = 0.8;         ///< ... of both faces together
  double min_face_m = 0.4;         ///< of a face on it
  double furniture_depth_m = 1.2;  ///< what stands against a wall is not deeper
  double furniture_side_m = 3.0;   ///< what stands free, or sticks out of a wall, is not longer
};

/// Of each face, whether it is a wall's for certain: by how much wall was seen on its line, or by
/// the wall's other face.
[[nodiscard]] std::vector<bool> are_walls(const Walls& walls, const BareFloorOptions& options);

/// The building as it would be seen without furniture: what stands free, or against walls that are
/// known, counts as floor, and so does the unseen behind it. The masks share the occupancy's box.
[[nodiscard]] Occupancy bare_floor(const Walls& walls, const Occupancy& occupancy,
                                   const BareFloorOptions& options);

/// The same where it is known which faces are walls, and these stand whatever is behind them:
/// sonars hear thin lines of walls, with gaps, around which the floor goes on.
[[nodiscard]] Occupancy bare_floor(const Walls& walls, const std::vector<bool>& is_wall,
                                   const Occupancy& occupancy, const BareFloorOptions& options);

}  // namespace roomatlas
