// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/locate/correlation.hpp"

#include <gtest/gtest.h>

#include <random>

namespace roomatlas {
namespace {

Raster<float> noise(const CellBox& box, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> value(-1.0F, 1.0F);
  Raster<float> raster(box);
  for (float& cell : raster.values) cell = value(random);
  return raster;
}

TEST(Correlation, ScoresAllShiftsAsSummingCellByCellDoes) {
  const CellBox building{{-7, 3}, {16, 20}};
  const CellBox box{{2, -4}, {8, 1}};
  const CorrelationPlane::Layers layers{noise(building, 1), noise(building, 2)};
  const CorrelationPlane::Query query{noise(box, 3), noise(box, 4)};
  const Raster<float> scores = CorrelationPlane(layers, 9).scores(query);
  int shifts = 0;
  for_each_cell(scores.domain, [&](const Cell& shift) {
    double sum = 0.0;
    for_each_cell(box, [&](const Cell& cell) {
      const Cell at{cell.x + shift.x, cell.y + shift.y};
      sum +=
          query.wall[cell] * layers.on_wall.get(at) + query.floor[cell] * layers.on_floor.get(at);
    });
    EXPECT_NEAR(scores[shift], sum, 1e-4) << shift.x << " " << shift.y;
    ++shifts;
  });
  EXPECT_EQ(shifts, (23 + 5) * (17 + 4));  // all that keep some of the query on the building
}

}  // namespace
}  // namespace roomatlas
