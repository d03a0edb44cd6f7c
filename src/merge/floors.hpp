// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "labels.hpp"
#include "roomatlas/planar/millimetre_grid.hpp"

#include "roomatlas/merge/merge.hpp"

#include <span>
#include <vector>

namespace roomatlas::planar {

/// One room of the input.
struct RoomEntry {
  RoomId id = 0;
  std::vector<AsrId> asrs;  ///< ascending, each once
};

/// The healed outlines of all rooms on the grid.
struct Outlines {
  std::vector<RoomEntry> rooms;    ///< by ascending id
  std::vector<Polygon> shapes_mm;  ///< simple; in the order of rooms
  std::vector<int> room_of_shape;  ///< parallel to `shapes_mm`
};

/// The outlines in an order that does not depend on that of the input. What had to be dropped or
/// healed becomes Issues. Shapes of one outline do not overlap.
[[nodiscard]] Outlines outlines_of(const std::vector<PlacedOutline>& outlines,
                                   const MillimetreGrid& grid, Issues& issues);

/// The room with most shapes over a place; a tie goes to the smaller room. Unknown where there is
/// none.
/// @param covering shapes, ascending.
/// @param room_mm2 the size of each room.
[[nodiscard]] Label owner(std::span<const int> covering, const std::vector<int>& room_of_shape,
                          const std::vector<double>& room_mm2);

/// The place of each room before doors and walls are set: pinholes are filled, and smaller pieces
/// of a room than `min_part_area_mm2` go to their surroundings, with an Issue.
/// @param first_outline of the map's shapes.
/// @return of each region its room or unknown.
[[nodiscard]] std::vector<Label> floor_labels(const RegionMap& regions, int first_outline,
                                              const Outlines& outlines, double min_part_area_mm2,
                                              Issues& issues);

}  // namespace roomatlas::planar
