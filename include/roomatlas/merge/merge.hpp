// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/merge/floor_plan.hpp"

#include <vector>

namespace roomatlas {

/// The outline of one ASR, placed in the building.
struct PlacedOutline {
  AsrId asr = 0;
  RoomId room = 0;
  Polygon outline;  ///< building metres; may self-intersect, repeat vertices, or be empty
};

/// A doorway, placed in the building.
struct PlacedDoor {
  Segment2 jambs;
  std::optional<RoomId> room_a;
  std::optional<RoomId> room_b;
};

struct MergeOptions {
  double wall_thickness_m = 0.15;  ///< of walls whose other side nobody saw; thicker hides gaps
  double min_part_area_m2 = 0.25;  ///< smaller islands of a room become part of what surrounds them
};

/// Merges placed outlines into one plan: every point of the plane is free space of at most one
/// room, a door opening, wall, or unknown. Each outline counts under the non-zero winding rule,
/// so that bow-ties, spikes, repeated vertices and reversed rings heal by themselves; what had to
/// be healed is an Issue. Where outlines of several rooms overlap, the room with more outlines
/// there has the place; a tie goes to the smaller room, because a view through a door is small.
/// Coordinates are rounded to millimetres. Empty input gives an empty plan. Never throws on
/// geometry; non-finite vertices are dropped and reported.
[[nodiscard]] FloorPlan merge(const std::vector<PlacedOutline>& outlines,
                              const std::vector<PlacedDoor>& doors, const MergeOptions& options);

/// The union of polygons under the non-zero rule (each polygon on its own), as disjoint polygons
/// with holes, outer rings counter-clockwise, largest first.
[[nodiscard]] std::vector<Polygon> union_of(const std::vector<Polygon>& polygons);

/// Area in square metres that both sets cover (each set counted as its union).
[[nodiscard]] double overlap_area(const std::vector<Polygon>& first,
                                  const std::vector<Polygon>& second);

}  // namespace roomatlas
