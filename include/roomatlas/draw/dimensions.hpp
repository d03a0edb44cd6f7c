// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/floor_plan.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace roomatlas {

/// The direction that most walls follow, modulo 90 degrees: what a sheet is laid along.
/// @returns the counter-clockwise angle from the building's x axis, in [-pi/4, pi/4); 0 where less
///   than a third of the rooms' edges (by length) run along it within 3 degrees, or at a right
///   angle
[[nodiscard]] double main_direction_rad(const FloorPlan& plan);

/// The rooms but for those with a direction of their own that is another one (of at least 60 % of
/// their edges, more than 6 degrees off): a wing at another angle is left out. All rooms where no
/// other is left.
[[nodiscard]] std::vector<const PlanRoom*> main_block(const FloorPlan& plan, double direction_rad);

/// Dimensions along one side of a building: from the outer face of one outside wall over the faces
/// of the walls that meet that side to the outer face of the other.
struct DimensionChain {
  Point2 origin = Point2::Zero();   ///< on the outermost face of that side; building metres
  Point2 along = Point2(1, 0);      ///< unit length
  Point2 outwards = Point2(0, -1);  ///< unit length, away from the building
  std::vector<double> stations_m;   ///< ascending, from `origin` along; two at least

  [[nodiscard]] double total_m() const { return stations_m.back() - stations_m.front(); }
  [[nodiscard]] Point2 at(std::size_t station) const {
    return origin + stations_m[station] * along;
  }
};

/// The chains below and to the left of the main block, as the sheet shows it (its right is the
/// main direction). A face counts where the outline that is seen from that side steps by at least
/// 0.3 m, at a wall that stands at a right angle to the chain. Empty for a plan without rooms.
[[nodiscard]] std::vector<DimensionChain> dimension_chains(const FloorPlan& plan);

/// The lengths between stations in whole centimetres, each within 1 cm of the true one: positions
/// are rounded, so that the parts of any chain over the same ends add up to the same total.
[[nodiscard]] std::vector<std::int64_t> centimetres(const std::vector<double>& stations_m);

/// The inside measures of a room.
struct RoomExtent {
  double width_m = 0.0;  ///< across the sheet, or nearest to that
  double depth_m = 0.0;
};

/// Width and depth of a room that is nearly a rectangle (it fills 85 % of its own box); else none.
/// @param direction_rad what the width runs along, if the room has no direction of its own
[[nodiscard]] std::optional<RoomExtent> extent_of(const PlanRoom& room, double direction_rad);

}  // namespace roomatlas
