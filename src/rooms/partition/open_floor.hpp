// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/rooms/partition_rooms.hpp"

namespace roomatlas {

/// The floor on which rooms are decided: free space, and furniture that stands in the middle of it.
struct OpenFloor {
  CellFrame frame;
  CellMask open{CellBox{}};
  /// Where walls may be: near obstacles that a mission saw; all cells of a finished map, for those
  /// often draw walls as if they had not been seen. Where beams end in nothing there is none.
  CellMask solid{CellBox{}};
  Raster<float>
      clearance_m;  ///< of a cell's centre from the nearest obstacle's face; 0 if not open

  double wall_noise_m = 0.0;  ///< how far a mission's walls stray from straight lines

  [[nodiscard]] bool is_open(const Point2& at) const { return open.at(frame.cell_of(at)); }
  [[nodiscard]] bool is_wall(const Point2& at) const {
    const Cell cell = frame.cell_of(at);
    return !open.at(cell) && (solid.at(cell) || !solid.domain.bounds().contains(cell));
  }
};

/// The clearance of the cells of a mask, in metres: half a cell less than the distance between
/// centres, so that it does not depend on the size of cells.
[[nodiscard]] Raster<float> clearance_m(const CellMask& mask, const CellFrame& frame);

/// A mission's free space without what beams leave behind: small holes are filled, strips narrower
/// than a robot sees are closed, and only what is connected to the path stays.
[[nodiscard]] CellMask without_beam_traces(const PartitionEvidence& evidence,
                                           const PartitionOptions& options);

/// The mask with obstacles filled that stand free and fit into a square of `side_m`, however it is
/// turned.
[[nodiscard]] CellMask islands_filled(const CellMask& mask, const CellFrame& frame, double side_m);

/// Its box is that of the free cells and one cell around them.
[[nodiscard]] OpenFloor open_floor(const PartitionEvidence& evidence,
                                   const PartitionOptions& options);

}  // namespace roomatlas
