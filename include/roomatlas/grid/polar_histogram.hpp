// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/grid/himm_grid.hpp"

namespace roomatlas {

struct PolarHistogramOptions {
  double sector_deg = 5.0;       ///< width of a cone; must divide 360. Wider smooths gaps away
  double window_radius_m = 2.0;  ///< cells farther away do not count
};

/// Polar histogram of obstacles around a point (paper II.A, equations (1) to (3)). Element i sums
/// the cells whose bearing beta lies in ((i-1), i] sectors, i = 1 ... n stored at i-1: k grows
/// with obstacles, the robot explores towards low values.
/// m = C^2 s, with s = 1 - distance / window_radius, so that near cells weigh more. Cells with
/// C <= 0, and the cell of the point itself, count nothing.
/// @throws std::invalid_argument when the sector does not divide 360 degrees
[[nodiscard]] std::vector<double> polar_histogram(const HimmGrid& grid, const Point2& center,
                                                  const PolarHistogramOptions& options);

}  // namespace roomatlas
