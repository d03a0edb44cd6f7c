// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "floor_sides.hpp"
#include "wall_support.hpp"

namespace roomatlas {

/// The line that would close an opening in line with a wall: from where the wall ends to the next
/// obstacle.
struct WallChord {
  Segment2 line;
  WallSupport at_a;  ///< of the wall beyond end a
  WallSupport at_b;
  bool is_known = false;  ///< a gap of a wall that is known otherwise
  [[nodiscard]] double length_m() const { return (line.b - line.a).norm(); }
};

/// The chords from both ends of each face that walls beyond their ends support, the strongest
/// first; none crosses a stronger one or runs beside it. Before them those that are known.
[[nodiscard]] std::vector<WallChord> find_wall_chords(const OpenFloor& floor,
                                                      const std::vector<FloorSide>& faces,
                                                      const std::vector<Segment2>& known);

/// Of each open cell the chord that runs over it, 1, 2, 3 ...; 0: none does.
[[nodiscard]] Raster<std::int32_t> chord_of_cell(const OpenFloor& floor,
                                                 const std::vector<WallChord>& chords);

}  // namespace roomatlas
