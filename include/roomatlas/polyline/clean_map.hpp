// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/grid/himm_grid.hpp"

namespace roomatlas {

enum class CellState : std::uint8_t { unknown, empty, occupied, robot_path };

/// A grid of decided cells; unknown outside of its box.
struct CellMap {
  CellFrame frame;
  CellBox box;
  std::vector<CellState> states;

  [[nodiscard]] CellState at(const Cell& cell) const {
    return box.contains(cell) ? states[box.index_of(cell)] : CellState::unknown;
  }
  [[nodiscard]] std::int64_t count(CellState state) const;
};

struct CleanOptions {
  double epsilon = 7.0;      ///< C > epsilon is occupied (paper IV). Higher drops faint walls
  double max_range_m = 5.0;  ///< how far the path may be for a cell to count as seen from it
  bool thin = true;          ///< break 2 x 2 blocks of occupied cells
};

/// CleanMap (paper III.B, Fig. 4 and 5): an occupied cell stays only if the robot's path can be
/// seen from it, so that each wall keeps its front layer alone; an empty cell that cannot be seen
/// falls back to unknown.
///
/// Seen: the line of cells to some cell on the rim of the path, at most max_range away along each
/// axis, meets no other occupied cell. The paper's loop casts rays to every cell of the square and
/// asks whether one meets the path; asking the rim of the path, nearest first, is many times
/// faster and loses the few cells from which only a ray to another cell, farther away or inside
/// the path, crosses it (docs/method.md has the measured difference). It never keeps a cell that
/// the paper's loop drops.
///
/// Where the loop leaves a 2 x 2 block of occupied cells, the one farthest from the path goes,
/// so that the nearest of the block stays; a neighbouring block may then take that one, in favour
/// of one nearer still.
///
/// The result's box is the grid's. Nothing is seen, and everything becomes unknown, without path.
[[nodiscard]] CellMap clean_map(const HimmGrid& grid, const CleanOptions& options);

}  // namespace roomatlas
