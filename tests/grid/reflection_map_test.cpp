// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/grid/reflection_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace roomatlas {
namespace {

std::vector<std::vector<Ray>> random_sweeps() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> metres(-3.0, 3.0);
  std::vector<std::vector<Ray>> sweeps(40);
  for (auto& sweep : sweeps) {
    for (int i = 0; i < 12; ++i) {
      sweep.push_back(
          {{{metres(random), metres(random)}, {metres(random), metres(random)}}, i % 3 != 0});
    }
  }
  return sweeps;
}

TEST(ReflectionMap, CountsAsTheRaysSay) {
  const auto sweeps = random_sweeps();
  ReflectionMap map(0.1);
  std::map<std::int64_t, CellCounts> counted;
  for (const auto& sweep : sweeps) {
    map.add_sweep(sweep);
    for (const Ray& ray : sweep) {
      const Cell end = map.frame().cell_of(ray.segment.b);
      for_each_cell_on_line(map.frame().cell_of(ray.segment.a), end, [&](const Cell& cell) {
        const bool is_spared =
            ray.ends_at_obstacle && std::abs(cell.x - end.x) <= 1 && std::abs(cell.y - end.y) <= 1;
        if (!is_spared) ++counted[key_of(cell)].passes;
        return true;
      });
      if (ray.ends_at_obstacle) ++counted[key_of(end)].hits;
    }
  }
  for_each_cell(map.box(), [&](const Cell& cell) {
    EXPECT_EQ(map.at(cell).hits, counted[key_of(cell)].hits);
    EXPECT_EQ(map.at(cell).passes, counted[key_of(cell)].passes);
  });
}

TEST(ReflectionMap, DoesNotDependOnTheOrderOfSweeps) {
  auto sweeps = random_sweeps();
  ReflectionMap map(0.1);
  for (const auto& sweep : sweeps) map.add_sweep(sweep);
  std::shuffle(sweeps.begin(), sweeps.end(), std::mt19937(8));
  ReflectionMap shuffled(0.1);
  for (const auto& sweep : sweeps) shuffled.add_sweep(sweep);
  for_each_cell(map.box(), [&](const Cell& cell) {
    EXPECT_EQ(map.at(cell).hits, shuffled.at(cell).hits);
    EXPECT_EQ(map.at(cell).passes, shuffled.at(cell).passes);
  });
}

TEST(ReflectionMap, KeepsTheShareWhenACellIsFull) {
  ReflectionMap map(0.1);
  const Ray through{{{0.05, 0.05}, {0.05, 0.05}}, false};
  const Ray hit{{{1.05, 0.05}, {0.05, 0.05}}, true};
  for (int i = 0; i < 70000; ++i) map.add_sweep({through, through, hit});
  EXPECT_NEAR(map.at({0, 0}).reflected_share(), 1.0 / 3.0, 0.01);
}

TEST(ReflectionMap, FindsAWallBetweenTwoCells) {
  ReflectionMap map(0.1);
  for (int i = 0; i < 30; ++i) map.add_sweep({{{{-1.0, 0.05}, {0.05, 0.05}}, true}});
  for (int i = 0; i < 10; ++i) map.add_sweep({{{{-1.0, 0.05}, {0.15, 0.05}}, true}});
  EXPECT_NEAR(map.mean_hit({0, 0}).x(), 0.075, 1e-9);
  EXPECT_NEAR(map.mean_hit({9, 9}).x(), 0.95, 1e-9) << "nothing was hit there: its centre";
}

}  // namespace
}  // namespace roomatlas
