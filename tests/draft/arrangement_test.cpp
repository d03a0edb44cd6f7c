// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/draft/arrangement.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace roomatlas {
namespace {

std::vector<DraftLine> random_lines(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> at(-3.0, 5.0);
  std::vector<DraftLine> lines;
  for (int i = 0; i < count; ++i) {
    lines.push_back({{{at(random), at(random)}, {at(random), at(random)}}, 1.0 + i, true});
  }
  return lines;
}

template <typename Visit>
void for_each_point(const Arrangement& arrangement, double step_m, Visit visit) {
  arrangement.for_each_run(step_m, [&](int cell, const Arrangement::Run& run) {
    for (std::int64_t i = 0; i < run.count; ++i) visit(cell, run.at(i));
  });
}

TEST(Arrangement, NeighboursInDifferentCellsHaveALineBetween) {
  std::mt19937 random(11);
  const std::vector<DraftLine> lines = random_lines(random, 25);
  const Arrangement arrangement(lines);
  constexpr double kStep_m = 0.05;
  Point2 last = Point2::Constant(1e9);
  int last_cell = -1;
  int different = 0;
  for_each_point(arrangement, kStep_m, [&](int cell, const Point2& at) {
    const bool are_neighbours = (at - last).norm() < 1.5 * kStep_m;
    if (are_neighbours && cell != last_cell) {
      ++different;
      const bool is_parted = std::any_of(lines.begin(), lines.end(), [&](const DraftLine& line) {
        return crossing_fraction({last, at}, line.segment).has_value();
      });
      EXPECT_TRUE(is_parted) << at.transpose();
    }
    last = at;
    last_cell = cell;
  });
  EXPECT_GT(different, 100);
}

TEST(Arrangement, CellsHaveAsMuchAreaAsPoints) {
  std::mt19937 random(12);
  const Arrangement arrangement(random_lines(random, 25));
  constexpr double kStep_m = 0.01;
  std::map<int, double> area_m2;
  for_each_point(arrangement, kStep_m,
                 [&](int cell, const Point2&) { area_m2[cell] += kStep_m * kStep_m; });
  EXPECT_GT(area_m2.size(), 20U);
  for (const auto& [cell, m2] : area_m2) {
    EXPECT_NEAR(m2, arrangement.area_m2(cell), 0.02 + 0.02 * m2) << cell;
  }
}

TEST(Arrangement, BordersKnowTheirLines) {
  // A square of faint lines, cut by a prominent one that ends inside of the other half.
  const std::vector<DraftLine> lines = {
      {{{0, 0}, {4, 0}}, 1.0, true},  {{{4, 0}, {4, 4}}, 1.0, true},
      {{{4, 4}, {0, 4}}, 1.0, true},  {{{0, 4}, {0, 0}}, 1.0, true},
      {{{2, -1}, {2, 5}}, 7.0, true}, {{{3, 1}, {3, 2}}, 9.0, false}};
  const Arrangement arrangement(lines);
  EXPECT_EQ(arrangement.cell_count(), 3);
  double inner_m = 0.0;
  for (const Arrangement::Border& border : arrangement.borders()) {
    if (border.left == 0 || border.right == 0) continue;
    EXPECT_EQ(border.prominence_m, 7.0);
    inner_m += (border.segment.b - border.segment.a).norm();
  }
  EXPECT_NEAR(inner_m, 4.0, 1e-9);
  const auto halves = arrangement.trace({-1, 0, 1}, 2);
  EXPECT_NEAR(area(halves[0].at(0)), 8.0, 1e-9);
  EXPECT_EQ(halves[1].at(0).outer.size(), 4U);
}

}  // namespace
}  // namespace roomatlas
