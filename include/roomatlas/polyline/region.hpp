// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/grid/cell_domain.hpp"

namespace roomatlas {

/// A set of cells of a domain.
struct CellMask {
  CellDomain domain;
  std::vector<std::uint8_t> bits;  ///< of each cell of the domain, by its number

  explicit CellMask(const CellBox& in) : CellMask(CellDomain(in)) {}
  explicit CellMask(const CellDomain& in) : domain(in), bits(in.count(), 0) {}
  [[nodiscard]] bool at(const Cell& cell) const {
    const std::size_t index = domain.find(cell);
    return index != CellDomain::kNone && bits[index] != 0;
  }
  /// Cells beyond the domain stay out of the set.
  void set(const Cell& cell, bool value) {
    const std::size_t index = domain.find(cell);
    if (index != CellDomain::kNone) bits[index] = value ? 1 : 0;
  }
  [[nodiscard]] std::int64_t count() const;
};

/// Cells of both, or of either, of two masks of one domain.
[[nodiscard]] CellMask both(CellMask first, const CellMask& second);
[[nodiscard]] CellMask either(CellMask first, const CellMask& second);
/// Cells within `radius` cells (a square) of the mask; the domain stays. Grows along rows, then
/// along columns of the domain's own cells.
[[nodiscard]] CellMask dilated(const CellMask& mask, int radius);
/// Cells whose square of `radius` lies in the mask; cells beyond the domain count as outside.
[[nodiscard]] CellMask eroded(const CellMask& mask, int radius);
/// The part of the mask that is connected (by edges) to a seed.
[[nodiscard]] CellMask connected_to(const CellMask& mask, const std::vector<Cell>& seeds);
/// The mask with holes of fewer than `max_cells` cells filled (holes connect by edges).
[[nodiscard]] CellMask holes_filled(const CellMask& mask, std::int64_t max_cells);

/// A boundary of a mask: the mid-points of the cell edges along it, counter-clockwise around the
/// mask, clockwise around holes, and for each the cell just outside.
struct CellBoundary {
  Ring edge_midpoints;
  std::vector<Cell> outside_cells;
};

/// All boundaries of the mask. Where two cells touch at a corner alone, the boundary passes
/// between them (the mask is 4-connected).
[[nodiscard]] std::vector<CellBoundary> trace_boundaries(const CellMask& mask,
                                                         const CellFrame& frame);

}  // namespace roomatlas
