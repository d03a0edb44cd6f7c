// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "grid.hpp"

#include "roomatlas/merge/merge.hpp"

#include <vector>

namespace roomatlas::planar {

/// What one room of the input holds, on the grid.
struct RoomOutlines {
  RoomId id = 0;
  std::vector<AsrId> asrs;         ///< ascending, each once
  std::vector<Polygon> shapes_mm;  ///< one an outline
  std::vector<AsrId> shape_asrs;   ///< parallel to `shapes_mm`
};

/// The outlines by ascending room id, in an order that does not depend on that of the input.
/// Dropped and repeated vertices become Issues.
[[nodiscard]] std::vector<RoomOutlines> room_outlines(const std::vector<PlacedOutline>& outlines,
                                                      const MillimetreGrid& grid, Issues& issues);

/// The place of each room before doors and walls are set, on whole millimetres, disjoint up to
/// that rounding; parallel to `rooms`.
/// @param min_part_area_mm2 smaller pieces of a room go to their surroundings.
[[nodiscard]] std::vector<std::vector<Polygon>> floors_of(const std::vector<RoomOutlines>& rooms,
                                                          double min_part_area_mm2, Issues& issues);

}  // namespace roomatlas::planar
