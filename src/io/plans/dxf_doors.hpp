// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomatlas/plan/floor_plan.hpp"

/// Symbols of doors as CAD programs have them: drawn once as a block, and inserted. Private.
namespace roomatlas::io {

/// What is drawn once: lines in the block's own frame, where a door is 1 wide.
struct DoorBlock {
  std::string name;  ///< letters, digits, hyphens
  std::vector<Polyline> lines;
};

/// Where a block stands, how it is turned and scaled.
struct DoorSymbol {
  DoorBlock block;
  Point2 at = Point2::Zero();  ///< of the block's origin, building metres
  double turn_deg = 0.0;       ///< counter-clockwise
  double scale_x = 1.0;        ///< along the opening: its width in metres
  double scale_y = 1.0;        ///< across it; negative where a leaf swings to the other side
};

/// The symbol of a door: `DOOR-80` with a leaf open by 80 degrees (in whole degrees) and its arc,
/// its origin the hinge and its x axis towards the other jamb; `DOOR` where no leaf was seen: shut,
/// from jamb to jamb; `PASSAGE`: the lintel alone; `WINDOW`: panes, across as deep as the wall.
/// Nothing for a door without width.
[[nodiscard]] std::optional<DoorSymbol> door_symbol(const PlanDoor& door);

}  // namespace roomatlas::io
