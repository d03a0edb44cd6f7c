// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/occupancy.hpp"
#include "roomatlas/draft/walls.hpp"

namespace roomatlas {

struct WallGapOptions {
  double min_line_m = 2.0;  ///< of wall on the line of a gap, in all; less will do where the
                            ///< wall on both sides runs from the gap to a prominent wall
  double min_stub_line_m = 0.4;
  double prominent_m = 2.5;
  double building_line_m = 5.0;  ///< lines with more run through the building: pieces of one wall
                                 ///< may be this far apart on them ...
  double building_reach_m = 40.0;
  double reach_m = 4.0;  ///< ... and on others this far
  double narrowest_m = 0.35;
  double free_m = 1.3;    ///< gaps up to this need no straight wall beside them ...
  double flank_m = 0.25;  ///< ... wider ones on one side this much ...
  double door_m = 2.0;    ///< ... and those wider than this on both
  double widest_m = 4.0;  ///< the widest gaps need `long_flank_m` of solid wall on both sides
  double long_flank_m = 1.5;
  double narrow_m = 0.9;    ///< gaps wider than this are narrower than the floor on both sides
  double widening_m = 0.3;  ///< by so much; else they are no doors but cuts across a corridor
};

/// Gaps in the lines of walls through which floor was seen: where doors may be. The shortest first.
[[nodiscard]] std::vector<Segment2> find_wall_gaps(const Walls& walls, const Occupancy& occupancy,
                                                   const WallGapOptions& options);

/// Whether the floor on one side of a line is wider than it by `by_m`, 0.4, 0.7 and 1 m away.
/// @param across unit vector towards that side
[[nodiscard]] bool widens(const CellMask& free, const CellFrame& frame, const Segment2& line,
                          const Point2& across, double by_m);

}  // namespace roomatlas
