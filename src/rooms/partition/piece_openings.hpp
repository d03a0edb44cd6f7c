// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "floor_pieces.hpp"
#include "passage.hpp"

namespace roomatlas {

/// Where two pieces of floor touch: one connected part of their common border.
struct PieceOpening {
  std::int32_t piece_a = 0;  ///< the smaller number
  std::int32_t piece_b = 0;
  Segment2 jambs;
  double width_m = 0.0;
  bool is_on_chord = false;  ///< the border follows a wall chord
  bool is_known = false;     ///< ... in a wall that is known otherwise
  WallSupport lower;         ///< of the walls beyond the two jambs, each figure's smaller value
  WallSupport higher;        ///< and its larger one
  Passage passage;
  int crossings = 0;  ///< how often the path goes through
};

/// All openings, by their pieces' numbers.
[[nodiscard]] std::vector<PieceOpening> find_piece_openings(const OpenFloor& floor,
                                                            const FloorPieces& pieces,
                                                            const std::vector<WallChord>& chords,
                                                            const ChordCells& chord_cells);

/// Counts how often a path goes through each opening.
void count_crossings(const std::vector<Pose2>& path, const CellFrame& frame,
                     const FloorPieces& pieces, std::vector<PieceOpening>& openings);

}  // namespace roomatlas
