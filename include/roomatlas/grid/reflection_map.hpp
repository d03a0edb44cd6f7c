// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/grid/cell_domain.hpp"
#include "roomatlas/grid/himm_grid.hpp"
#include "roomatlas/grid/tile_grid.hpp"

namespace roomatlas {

/// What beams said of one cell.
struct CellCounts {
  std::uint16_t hits = 0;    ///< beams that ended here at an obstacle
  std::uint16_t passes = 0;  ///< beams that went on
  [[nodiscard]] bool is_seen() const { return hits > 0 || passes > 0; }
  /// Share of the beams that the cell reflected, [0, 1]; 0 for a cell that was not seen.
  [[nodiscard]] double reflected_share() const {
    const int all = hits + passes;
    return all > 0 ? static_cast<double>(hits) / all : 0.0;
  }
};

/// The counting model of occupancy (Haehnel 2004; Thrun, Burgard, Fox 2005, section 9): of each
/// cell the share of beams that it reflected. Unlike HIMM it does not forget and does not depend
/// on the order of the sweeps, so that many visits average: the map of a whole mission, once its
/// poses are known. Has no bounds; keeps what was seen alone.
class ReflectionMap {
 public:
  explicit ReflectionMap(double cell_m) : frame_{cell_m} {}

  /// Counts one sweep. A ray's own hit and the cells that touch it get no pass from it, so that a
  /// wall met at a flat angle is not worn away.
  void add_sweep(const std::vector<Ray>& rays);

  /// Adds what other beams said, in cells of the same size.
  void add(const ReflectionMap& other);

  /// Says what is known of a cell otherwise, such as from a finished map.
  void set(const Cell& cell, const CellCounts& counts) { counts_.edit(cell) = counts; }

  [[nodiscard]] CellCounts at(const Cell& cell) const { return counts_.at(cell); }
  /// The mean of the hits' cells around a cell (3 x 3), weighted by their number: finer than a
  /// cell where a wall runs between two. The cell's centre where nothing was hit.
  [[nodiscard]] Point2 mean_hit(const Cell& cell) const;
  [[nodiscard]] const CellFrame& frame() const { return frame_; }
  [[nodiscard]] CellBox box() const { return counts_.box(); }
  /// The cells that a building's masks have: those of `box()` and so many more on each side; of a
  /// building that is mostly empty (a fifth of the box and less) only those within some metres of
  /// what was seen, so that every gap in it that may be furniture is whole.
  [[nodiscard]] CellDomain domain(int border_cells) const;

 private:
  CellFrame frame_;
  TileGrid<CellCounts> counts_;
};

}  // namespace roomatlas
