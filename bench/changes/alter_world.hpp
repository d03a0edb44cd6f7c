// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "everywhere/draw.hpp"
#include "roomatlas/plan/change.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas::bench {

/// What was done to a world; world metres.
struct Alteration {
  ChangeKind kind = ChangeKind::furniture_gone;
  Point2 from = Point2::Zero();   ///< the middle of what stood ...
  Point2 to = Point2::Zero();     ///< ... and of what stands; the same where nothing was moved
  std::vector<RoomId> rooms;      ///< that it can be seen from
  std::vector<Polygon> outlines;  ///< of what stood and of what stands
};

/// A world as two missions find it.
struct AlteredWorld {
  FloorPlan before;
  FloorPlan after;
  std::vector<Alteration> alterations;
};

/// Alters a world in up to `count` places: doors shut or opened that leave a way round, pieces of
/// furniture of 0.15 m2 and more gone, new or moved by 0.4 m and more, walls of 1 m to 2.5 m built
/// or taken away. Nothing overlaps anything or stands in the way of a door.
[[nodiscard]] AlteredWorld altered(const FloorPlan& world, int count, Draw& draw);

}  // namespace roomatlas::bench
