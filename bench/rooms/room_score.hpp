// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/grid/raster.hpp"

#include <cstdint>

namespace roomatlas::bench {

/// How well rooms were found; true and found rooms are paired one to one so that the sum of their
/// IoUs (intersection over union) is greatest.
struct RoomScore {
  int true_rooms = 0;
  int found_rooms = 0;             ///< of at least 0.25 m2
  double f1_half = 0.0;            ///< pairs of IoU >= .5, as F1
  double f1_three_quarters = 0.0;  ///< the same at .75
  double mean_iou = 0.0;           ///< over true rooms; 0 for one without a partner
};

/// Cells of true rooms alone count for areas. Both rasters have one box; 0: no room.
[[nodiscard]] RoomScore room_score(const Raster<std::int32_t>& found,
                                   const Raster<std::int32_t>& truth, double cell_m);

}  // namespace roomatlas::bench
