// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cell_grid.hpp"
#include "roomatlas/core/geometry.hpp"

#include <vector>

namespace roomatlas::io {

/// A 4-connected region of cells that have one value.
struct TracedRegion {
  int value = 0;
  Polygon outline;  ///< in cells: (0, 0) is the lower left corner of the lower left cell
};

/// The outlines of all regions of equal values but 0, along the edges of their cells: the outer
/// ring counter-clockwise, holes clockwise, corners only. Regions come in the order of their
/// lowest, then leftmost cell. Where a region touches itself at a corner its ring goes through
/// that corner twice, without crossing itself. Time and memory are linear in the cells.
[[nodiscard]] std::vector<TracedRegion> trace_cells(const CellGrid<int>& values);

}  // namespace roomatlas::io
