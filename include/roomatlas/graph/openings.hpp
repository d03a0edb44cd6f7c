// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/graph/building_grid.hpp"

namespace roomatlas {

struct OpeningOptions {
  double min_width_m = 0.35;      ///< sonars hear jambs early: a door of 0.9 m looks like 0.6 m
  double max_width_m = 1.3;       ///< larger takes narrow corridors for doors
  double widening_m = 0.5;        ///< the space on both sides must be this much wider
  double min_beside_share = 0.4;  ///< of the line beyond each jamb (0.8 m) that is not free
};

/// A narrow place between two obstacles, wider on both sides: a doorway, a window, or a gap between
/// pieces of furniture.
struct Opening {
  Segment2 jambs;            ///< building metres; left and right of `heading_rad`
  double heading_rad = 0.0;  ///< across it, one of its two directions
  [[nodiscard]] Point2 middle() const { return (jambs.a + jambs.b) / 2.0; }
  [[nodiscard]] double width_m() const { return (jambs.a - jambs.b).norm(); }
};

/// The openings of a building, whether the robot went through them or not; the narrowest first.
///
/// From each passable cell near obstacles the narrowest chord between two obstacles is taken, if
/// its mid-point is passable 0.45 m both ways. Of all chords within 0.7 m the narrowest speaks; it
/// is an opening when 0.4 to 0.8 m off the space is wider on both sides, on one of them beyond
/// each of its two jambs (beside the gap between a table and a wall the wall goes on), and when
/// the line beyond the jambs is mostly not free.
[[nodiscard]] std::vector<Opening> find_openings(const BuildingGrid& grid,
                                                 const OpeningOptions& options);

/// The same opening with its jambs where most beams were reflected: an obstacle begins where the
/// first echoes lie, and in front of a jamb those of a sonar's cone lie up to 0.2 m inside the
/// door.
[[nodiscard]] Opening with_jambs_at_peaks(const Opening& opening, const ReflectionMap& map);

}  // namespace roomatlas
