// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/distance_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/spotty_domain.hpp"

namespace roomatlas {
namespace {

/// The same by trying all cells, and those just outside of the box.
float by_trying(const CellMask& mask, const Cell& from) {
  if (!mask.at(from)) return 0.0F;
  double nearest = std::numeric_limits<double>::infinity();
  const CellBox around{{mask.domain.bounds().min.x - 1, mask.domain.bounds().min.y - 1},
                       {mask.domain.bounds().max.x + 1, mask.domain.bounds().max.y + 1}};
  for_each_cell(around, [&](const Cell& cell) {
    if (!mask.at(cell)) nearest = std::min(nearest, distance_cells(from, cell));
  });
  return static_cast<float>(nearest);
}

TEST(DistanceInside, IsTheDistanceToTheNearestCellThatIsNotInTheMask) {
  std::mt19937 random(7);
  for (const int share : {1, 5, 40}) {  // percent of cells that are not in the mask
    CellMask mask({{-7, 3}, {34, 22}});
    for_each_cell(mask.domain, [&](const Cell& cell) {
      mask.set(cell, static_cast<int>(random() % 100U) >= share);
    });
    const Raster<float> field = distance_inside(mask);
    for_each_cell(mask.domain, [&](const Cell& cell) {
      ASSERT_FLOAT_EQ(field[cell], by_trying(mask, cell)) << cell.x << ' ' << cell.y;
    });
  }
}

TEST(DistanceInside, IsTheSameOnADomainThatIsNoBox) {
  std::mt19937 random(8);
  for (int round = 0; round < 8; ++round) {
    CellMask mask(test::spotty_domain(random, {{-7, 3}, {34, 22}}));
    for_each_cell(mask.domain, [&](const Cell& cell) { mask.set(cell, random() % 20U != 0U); });
    const Raster<float> field = distance_inside(mask);
    for_each_cell(mask.domain, [&](const Cell& cell) {
      ASSERT_FLOAT_EQ(field[cell], by_trying(mask, cell)) << cell.x << ' ' << cell.y;
    });
  }
}

TEST(DistanceInside, GrowsFromTheRimOfAFullBox) {
  CellMask mask({{0, 0}, {9, 5}});
  for_each_cell(mask.domain, [&](const Cell& cell) { mask.set(cell, true); });
  EXPECT_FLOAT_EQ(distance_inside(mask).get({4, 2}), 3.0F);
  EXPECT_FLOAT_EQ(distance_inside(mask).get({0, 0}), 1.0F);
}

}  // namespace
}  // namespace roomatlas
