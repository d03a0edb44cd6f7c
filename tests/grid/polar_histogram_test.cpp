// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/grid/polar_histogram.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace roomatlas {
namespace {

HimmGrid grid_with_hit(const Cell& hit) {
  HimmGrid grid(0.1);
  const Point2 at = grid.frame().center_of(hit);
  grid.add_sweep({{{at, at}, true}});
  return grid;
}

TEST(PolarHistogram, MatchesAHandComputedSumForOneHit) {
  const HimmGrid grid = grid_with_hit({10, 0});  // value 3 at (1.05, .05), 1.5 around it
  const Point2 center(0.05, 0.05);
  const auto density = polar_histogram(grid, center, {.sector_deg = 90.0, .window_radius_m = 2.0});
  ASSERT_EQ(density.size(), 4U);
  const auto m = [](double certainty, double dx, double dy) {
    return certainty * certainty * (1.0 - std::hypot(dx, dy) / 2.0);
  };
  const double above = m(1.5, 0.9, 0.1) + m(1.5, 1.0, 0.1) + m(1.5, 1.1, 0.1);
  const double on_axis = m(1.5, 0.9, 0.0) + m(3.0, 1.0, 0.0) + m(1.5, 1.1, 0.0);
  EXPECT_NEAR(density[0], above, 1e-9);            // 0 < beta <= 90
  EXPECT_NEAR(density[3], above + on_axis, 1e-9);  // 270 < beta <= 360: the axis belongs here
  EXPECT_EQ(density[1] + density[2], 0.0);
}

TEST(PolarHistogram, KeepsTheTotalWhateverTheSector) {
  const HimmGrid grid = grid_with_hit({-7, 9});
  const auto total = [&](double sector_deg) {
    const auto k = polar_histogram(grid, {0.0, 0.0}, {.sector_deg = sector_deg});
    return std::accumulate(k.begin(), k.end(), 0.0);
  };
  EXPECT_GT(total(5.0), 0.0);
  EXPECT_NEAR(total(5.0), total(30.0), 1e-9);
}

TEST(PolarHistogram, RefusesASectorThatDoesNotDivideTheCircle) {
  EXPECT_THROW((void)polar_histogram(HimmGrid(0.1), {0, 0}, {.sector_deg = 7.0}),
               std::invalid_argument);
}

}  // namespace
}  // namespace roomatlas
