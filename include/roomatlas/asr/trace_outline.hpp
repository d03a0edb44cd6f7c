// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "roomatlas/asr/map_room.hpp"
#include "roomatlas/polyline/region.hpp"

namespace roomatlas {

/// The wall's surface near a cell just outside of a region; nothing where no wall stands.
using WallNear = std::function<std::optional<Point2>(const Cell& outside)>;

/// The outline of a region of free cells: its boundaries follow the walls where there are any, and
/// the region's own limit elsewhere; simplified and fitted with lines, jambs kept as corners.
/// The largest outer boundary and the holes in it; empty for an empty region.
[[nodiscard]] Polygon trace_outline(const CellMask& region, const CellFrame& frame,
                                    const WallNear& wall_near, const std::vector<Point2>& jambs,
                                    const RoomMapOptions& options);

/// The cell nearest to `outside`, at most two cells off, for which `is_wall` holds.
[[nodiscard]] std::optional<Cell> nearest_wall_cell(
    const Cell& outside, const std::function<bool(const Cell&)>& is_wall);

}  // namespace roomatlas
