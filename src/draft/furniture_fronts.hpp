// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/walls.hpp"

namespace roomatlas {

/// Sets fronts of furniture apart from walls: stretches of a face behind which, where they end, a
/// wall of the same side comes into sight. They become faces of their own (`is_furniture`), and the
/// wall goes on behind them (`hidden`). What is behind a front was never seen: that it is a row of
/// cupboards and no step in the wall is a guess, by its depth.
/// @param faces confirmed; those that follow no direction of the building stay as they are
void set_fronts_apart(const Occupancy& occupancy, const WallOptions& options,
                      std::vector<WallFace>& faces);

/// The share of a stretch along a face, `off_m` off it, on which nothing stands and beams went
/// through.
/// @param near_obstacle obstacles and the cells around
[[nodiscard]] double free_share(const WallFace& face, const Interval& stretch, double off_m,
                                const Occupancy& occupancy, const CellMask& near_obstacle);

}  // namespace roomatlas
