// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/grid/raster.hpp"
#include "roomatlas/polyline/region.hpp"

namespace roomatlas {

/// For each cell of the mask the Euclidean distance, in cells, from its centre to the centre of the
/// nearest cell that is not in the mask; 0 for cells that are not. Cells beyond the domain
/// count as not in the mask. Exact (Felzenszwalb and Huttenlocher, "Distance transforms of sampled
/// functions", Theory of Computing 2012); linear in the number of cells.
[[nodiscard]] Raster<float> distance_inside(const CellMask& mask);

}  // namespace roomatlas
