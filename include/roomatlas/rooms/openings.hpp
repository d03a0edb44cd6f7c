// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/plan/door.hpp"
#include "roomatlas/rooms/building_grid.hpp"

namespace roomatlas {

struct OpeningOptions {
  double min_width_m = 0.35;      ///< sonars hear jambs early: a door of 0.9 m looks like 0.6 m
  double max_width_m = 1.3;       ///< larger takes narrow corridors for doors
  double widening_m = 0.5;        ///< the space on both sides must be this much wider
  double min_beside_share = 0.4;  ///< of the line beyond each jamb (0.8 m) that is not free
};

/// The openings of a building, narrow places between two obstacles, wider on both sides: doorways,
/// windows, gaps between pieces of furniture. Whether the robot went through them or not; the
/// narrowest first; building metres.
///
/// From each passable cell near obstacles the narrowest chord between two obstacles is taken, if
/// its mid-point is passable 0.45 m both ways. Of all chords within 0.7 m the narrowest speaks; it
/// is an opening when 0.4 to 0.8 m off the space is wider on both sides, on one of them beyond
/// each of its two jambs (beside the gap between a table and a wall the wall goes on), and when
/// the line beyond the jambs is mostly not free.
[[nodiscard]] std::vector<Doorway> find_openings(const BuildingGrid& grid,
                                                 const OpeningOptions& options);

/// The same opening with its jambs where most beams were reflected: an obstacle begins where the
/// first echoes lie, and in front of a jamb those of a sonar's cone lie up to 0.2 m inside the
/// door.
[[nodiscard]] Doorway with_jambs_at_peaks(const Doorway& opening, const ReflectionMap& map);

}  // namespace roomatlas
