// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/grid/polar_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace roomatlas {

std::vector<double> polar_histogram(const HimmGrid& grid, const Point2& center,
                                    const PolarHistogramOptions& options) {
  const double exact_sectors = 360.0 / options.sector_deg;
  const auto sectors = static_cast<int>(std::lround(exact_sectors));
  if (!(options.sector_deg > 0.0) || std::abs(exact_sectors - sectors) > 1e-9) {
    throw std::invalid_argument("polar histogram: the sector must divide 360 degrees");
  }
  std::vector<double> density(static_cast<std::size_t>(sectors), 0.0);
  const Point2 reach = Point2::Constant(options.window_radius_m);
  const Cell low = grid.frame().cell_of(center - reach);
  const Cell high = grid.frame().cell_of(center + reach);
  for_each_cell({low, {high.x + 1, high.y + 1}}, [&](const Cell& cell) {
    const double certainty = grid.value(cell);
    if (certainty <= 0.0) return;
    const Point2 offset = grid.frame().center_of(cell) - center;
    const double distance_m = offset.norm();
    if (distance_m >= options.window_radius_m || distance_m == 0.0) return;
    // (1) beta = arctan((j - y0) / (i - x0)), over the full circle
    double beta_deg = degrees(std::atan2(offset.y(), offset.x()));
    if (beta_deg <= 0.0) beta_deg += 360.0;
    // (2) m = C^2 s
    const double magnitude = certainty * certainty * (1.0 - distance_m / options.window_radius_m);
    // (3) k_phi sums m over phi - 1 < beta <= phi, in units of the sector
    const auto phi = static_cast<int>(std::ceil(beta_deg / options.sector_deg - 1e-9));
    density[static_cast<std::size_t>(std::clamp(phi, 1, sectors) - 1)] += magnitude;
  });
  return density;
}

}  // namespace roomatlas
