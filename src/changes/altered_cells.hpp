// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/changes/find_changes.hpp"
#include "roomatlas/polyline/region.hpp"

namespace roomatlas::changes {

/// What a mission says of the cells of a box.
struct SeenCells {
  CellMask seen{CellBox{}};      ///< a beam reached or crossed it, or the robot stood there
  CellMask standing{CellBox{}};  ///< something stands there
  CellMask clear{CellBox{}};     ///< nothing does, by several beams or by the robot itself
  CellMask touched{CellBox{}};   ///< something was hit there, though perhaps it did not stay
};

/// @param times of the visits, null where they are of one mission
[[nodiscard]] SeenCells seen_cells(const BuildingEvidence& evidence, const VisitTimes* times,
                                   const CellBox& box, const ChangeOptions& options);

/// Cells where something stands for one mission, and the other saw nothing there nor near.
[[nodiscard]] CellMask only_in(const SeenCells& one, const SeenCells& other, double cell_m,
                               const ChangeOptions& options);

/// Cells that are one thing: they touch, but for small gaps.
using CellGroup = std::vector<Cell>;

/// Groups of at least `min_cells`, in the order of their lowest cells.
[[nodiscard]] std::vector<CellGroup> groups_of(const CellMask& mask, double cell_m,
                                               const ChangeOptions& options);

}  // namespace roomatlas::changes
