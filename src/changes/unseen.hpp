// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "altered_cells.hpp"

namespace roomatlas::changes {

/// A mission's cells with its path and its plan.
struct Seen {
  const SeenCells& cells;
  const std::vector<Pose2>& path;
  const FloorPlan& plan;
};

/// Rooms that one of the missions entered and the other did not, those of the old one first.
[[nodiscard]] std::vector<OneSidedRoom> one_sided_rooms(const Seen& before, const Seen& after,
                                                        const CellFrame& frame);

/// What of the old plan's rooms the old mission saw and the new one did not.
[[nodiscard]] std::vector<Polygon> not_seen_again(const Seen& before, const SeenCells& after,
                                                  const CellFrame& frame,
                                                  const ChangeOptions& options);

}  // namespace roomatlas::changes
