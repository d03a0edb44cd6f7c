// SPDX-License-Identifier: GPL-3.0-or-later
// Corners of rooms that sonars did not hear.
#pragma once

#include <vector>

#include "roomatlas/merge/regular_walls.hpp"

namespace roomatlas {

/// The ring with a corner instead of each short edge that cuts one off: between two walls that
/// follow directions of the building and meet at a right angle beyond it, inside the room's angle.
/// A door's threshold is no wall. Nothing changes where `options.blind_corner_m` is 0.
[[nodiscard]] Ring with_closed_corners(const Ring& ring, const std::vector<Door>& doors,
                                       const std::vector<double>& directions_rad,
                                       const RegularWallOptions& options);

}  // namespace roomatlas
