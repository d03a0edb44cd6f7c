// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/occupancy.hpp"
#include "roomatlas/draft/walls.hpp"

namespace roomatlas {

struct WallGapOptions {
  double narrowest_m = 0.35;
  double short_m = 2.5;         ///< gaps up to this need little wall on both sides ...
  double short_flank_m = 0.25;  ///< ... this much
  double widest_m = 4.0;        ///< wider ones part nothing
  double long_flank_m = 1.5;    ///< what gaps wider than `short_m` need
  double min_line_m = 3.0;      ///< of wall on the line of the gap, in all
};

/// Gaps in the lines of walls through which floor was seen: where doors may be.
[[nodiscard]] std::vector<Segment2> find_wall_gaps(const Walls& walls, const Occupancy& occupancy,
                                                   const WallGapOptions& options);

}  // namespace roomatlas
