// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wall_chords.hpp"

namespace roomatlas {

/// The floor cut into far too many pieces.
struct FloorPieces {
  Raster<std::int32_t> piece_of_cell;  ///< 0: not open; pieces are 1, 2, 3 ...
  std::int32_t count = 0;
  std::vector<double> radius_m;  ///< by piece: the largest clearance while chords are walls; [0]
                                 ///< stands for none
};

/// Floods the field from its peaks down: two peaks stay apart when the saddle between them is lower
/// than `saddle_share` of the lower one.
/// @returns 0 where the field is 0; else the number of the peak, 1, 2, 3 ...
[[nodiscard]] Raster<std::int32_t> flooded(const Raster<float>& field, double saddle_share);

/// Cuts along chords, then at narrow places. Cells under a chord go to the piece beside them.
[[nodiscard]] FloorPieces cut_floor(const OpenFloor& floor, const ChordCells& chords);

}  // namespace roomatlas
