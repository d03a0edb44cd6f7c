// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "floors.hpp"
#include "shape_index.hpp"

#include "roomatlas/core/geometry.hpp"

#include <vector>

namespace roomatlas::planar {

/// The floors of all rooms, to be asked what lies along a line.
struct FloorLookup {
  const Outlines& outlines;
  const ShapeIndex& shapes;      ///< of the outlines
  std::vector<double> room_mm2;  ///< size of each room, for `owner`

  FloorLookup(const Outlines& of, const ShapeIndex& index);
};

/// The rectangle on the jamb line that reaches from the floor on one side of the wall to the
/// floor on the other, four corners counter-clockwise, on whole millimetres.
/// The floor is looked for perpendicular to the line, up to 0.6 m each way, between the jambs
/// and just beside them: floors often run into the doorway, and there the wall beside it tells
/// how deep the doorway is. Where a side has no floor the opening is one wall thickness deep.
/// @param jambs_mm at least a millimetre long.
/// @param first, second the rooms that the door joins, -1 where unknown: of several gaps the one
///   between these is preferred.
[[nodiscard]] Ring door_opening(const Segment2& jambs_mm, const FloorLookup& floors, int first,
                                int second, double wall_thickness_mm);

}  // namespace roomatlas::planar
