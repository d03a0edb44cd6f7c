// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "floor_sides.hpp"
#include "wall_support.hpp"

namespace roomatlas {

/// The line that would close an opening in line with a wall: from where the wall ends to the next
/// obstacle.
struct WallChord {
  Segment2 line;
  WallSupport at_a;  ///< of the wall beyond end a
  WallSupport at_b;
  bool is_known = false;  ///< a gap of a wall that is known otherwise
  [[nodiscard]] double length_m() const { return (line.b - line.a).norm(); }
};

/// The chords from both ends of each face that walls beyond their ends support, the strongest
/// first; none crosses a stronger one or runs beside it. Before them those that are known.
[[nodiscard]] std::vector<WallChord> find_wall_chords(const OpenFloor& floor,
                                                      const std::vector<FloorSide>& faces,
                                                      const std::vector<Segment2>& known);

/// The chords of the few open cells that chords run over.
class ChordCells {
 public:
  /// Cells under several chords belong to the last one.
  ChordCells(const OpenFloor& floor, const std::vector<WallChord>& chords);

  /// The chord that runs over a cell, 1, 2, 3 ...; 0: none does.
  [[nodiscard]] std::int32_t at(const Cell& cell) const {
    const auto found = chord_.find(domain_.find(cell));
    return found != chord_.end() ? found->second : 0;
  }
  /// The mask without the cells under chords; it has the floor's domain.
  [[nodiscard]] CellMask cut_out_of(CellMask mask) const;

 private:
  CellDomain domain_;
  std::unordered_map<std::size_t, std::int32_t> chord_;  ///< by number of the cell
};

}  // namespace roomatlas
