// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "open_floor.hpp"

namespace roomatlas {

/// A straight piece of the floor's boundary; the floor lies left of the way from a to b.
struct FloorSide {
  Segment2 ends;
  double heading_rad = 0.0;  ///< of the way from a to b, along a direction of the building's walls
                             ///< where one is near
  [[nodiscard]] double length_m() const { return (ends.b - ends.a).norm(); }
};

/// The directions of the building's walls, modulo 180 degrees, ascending, [0, pi): peaks of the
/// histogram of the faces' headings, in which long faces count more than short ones.
[[nodiscard]] std::vector<double> wall_directions_rad(const std::vector<Segment2>& faces);

/// All faces that are long enough for a wall and follow one of the building's directions, or are
/// very long; each along its direction.
[[nodiscard]] std::vector<FloorSide> find_floor_sides(const OpenFloor& floor);

}  // namespace roomatlas
