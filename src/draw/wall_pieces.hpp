// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "segment_grid.hpp"

#include "roomatlas/plan/floor_plan.hpp"

#include <vector>

/// Parts of wall bodies that are drawn unlike the rest; building metres.
namespace roomatlas::drawing {

/// The faces of walls, each with its wall to the left.
[[nodiscard]] SegmentGrid wall_faces(const std::vector<Polygon>& walls);

/// The stretches of walls between two parallel faces at most `thickest_m` apart, as quadrilaterals
/// with their long sides on the faces; what lies between two of them, where walls meet or cross, is
/// one too if it is no longer than that.
[[nodiscard]] std::vector<Ring> thin_walls(const SegmentGrid& faces, double thickest_m);

/// A piece of wall that nobody measured, behind a room's edge.
struct AssumedWall {
  Segment2 edge;  ///< the room lies to its left
  WallEvidence evidence = WallEvidence::inferred;
  double depth_m = 0.0;  ///< of the wall behind it
  bool is_half = false;  ///< its other face was measured: the depth is half of the wall's
  [[nodiscard]] Point2 back() const;    ///< from the edge to the wall's other side
  [[nodiscard]] Segment2 face() const;  ///< that side
};

/// The walls behind the edges that were not measured, in pieces of one thickness.
[[nodiscard]] std::vector<AssumedWall> assumed_pieces(const FloorPlan& plan,
                                                      const SegmentGrid& faces);

/// What they take, and the corners between them, which lie behind neither of two of them.
[[nodiscard]] std::vector<Ring> bodies_of(const std::vector<AssumedWall>& walls);

}  // namespace roomatlas::drawing
