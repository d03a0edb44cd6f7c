// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/map_room.hpp"

namespace roomatlas {

/// The outline of the free space around the path, cut at the door lines (map_room's last step).
/// Its boundary follows the walls where there are any, and the limit of what was seen elsewhere.
[[nodiscard]] Polygon outline_of(const HimmGrid& grid, const CellMap& cleaned,
                                 const std::vector<PathSample>& path,
                                 const std::vector<Exit>& exits, const RoomMapOptions& options);

/// The jambs of the doorways among the exits.
[[nodiscard]] std::vector<Point2> jambs_of(const std::vector<Exit>& exits);

}  // namespace roomatlas
