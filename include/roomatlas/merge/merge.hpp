// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/door.hpp"
#include "roomatlas/plan/floor_plan.hpp"
#include "roomatlas/plan/placed_outline.hpp"

#include <vector>

namespace roomatlas {

struct MergeOptions {
  double wall_thickness_m = 0.15;  ///< of walls whose other side nobody saw; thicker hides gaps
  double min_part_area_m2 = 0.25;  ///< smaller islands of a room become part of what surrounds them
};

/// Merges placed outlines into one plan: every point of the plane is free space of at most one
/// room, a door opening, wall, or unknown. Each outline counts under the non-zero winding rule,
/// so that bow-ties, spikes, repeated vertices and reversed rings heal by themselves; what had to
/// be healed is an Issue. Where outlines of several rooms overlap, the room with more outlines
/// there has the place; a tie goes to the smaller room, because a view through a door is small.
/// Outside of rooms and doors, walls are as thick as the option says around each outline, and where
/// `wall_bodies` say so.
/// Coordinates are rounded to millimetres. Empty input gives an empty plan. Never throws on
/// geometry; non-finite vertices are dropped and reported.
[[nodiscard]] FloorPlan merge(const std::vector<PlacedOutline>& outlines,
                              const std::vector<Door>& doors, const MergeOptions& options,
                              const std::vector<Polygon>& wall_bodies = {});

}  // namespace roomatlas
