// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "roomatlas/plan/floor_plan.hpp"

/// Wall bodies as a building model has them: one straight wall after another. Private.
namespace roomatlas::io {

/// A piece of the walls. Those of a plan are disjoint, and together cover its wall bodies with the
/// holes of doors, passages and windows closed.
struct WallSegment {
  Polygon outline;
  std::optional<Segment2> axis;  ///< its middle from end to end, where it runs straight
  double thickness_m = 0.0;      ///< of a straight one
  bool is_rectangle = false;     ///< neither end is cut askew
};

/// Walls between two parallel faces at most 0.6 m apart, the longest run through where they meet;
/// then what is left over, such as pillars and round walls. Pieces below 10 cm2 are left out.
[[nodiscard]] std::vector<WallSegment> wall_segments(const FloorPlan& plan);

}  // namespace roomatlas::io
