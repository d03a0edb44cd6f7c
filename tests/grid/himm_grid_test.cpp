// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/grid/himm_grid.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>

namespace roomatlas {
namespace {

Ray ray_of_cells(Cell from, Cell to, bool obstacle) {
  const CellFrame frame{0.1};
  return {{frame.center_of(from), frame.center_of(to)}, obstacle};
}

TEST(HimmGrid, AHitRaisesItsCellByThreeAndItsEightNeighborsByOneAndAHalf) {
  HimmGrid grid(0.1);
  grid.add_sweep({ray_of_cells({0, 0}, {10, 0}, true)});
  EXPECT_EQ(grid.value({10, 0}), 3.0);
  for (const Cell neighbor : {Cell{9, 0}, {11, 0}, {9, 1}, {10, -1}, {11, 1}}) {
    EXPECT_EQ(grid.value(neighbor), 1.5);
  }
  EXPECT_EQ(grid.value({5, 0}), -1.0);
  EXPECT_EQ(grid.value({0, 0}), -1.0);
  EXPECT_EQ(grid.value({12, 0}), 0.0);
}

TEST(HimmGrid, ValuesStayBetweenMinusThreeAndFifteen) {
  HimmGrid grid(0.1);
  for (int i = 0; i < 40; ++i) grid.add_sweep({ray_of_cells({0, 0}, {10, 0}, true)});
  EXPECT_EQ(grid.value({10, 0}), 15.0);
  EXPECT_EQ(grid.value({5, 0}), -3.0);
}

TEST(HimmGrid, NoEchoLowersTheWholeRayAndRaisesNothing) {
  HimmGrid grid(0.1);
  grid.add_sweep({ray_of_cells({0, 0}, {4, 0}, false)});
  EXPECT_EQ(grid.value({4, 0}), -1.0);
  EXPECT_EQ(grid.value({4, 1}), 0.0);
}

TEST(HimmGrid, RobotPathStaysWhateverIsSeenLater) {
  HimmGrid grid(0.1);
  grid.mark_robot({0.05, 0.05, 0.0}, {0.3, 0.1});
  EXPECT_TRUE(grid.is_robot_path({0, 0}));
  EXPECT_TRUE(grid.is_robot_path({1, 0}));
  EXPECT_FALSE(grid.is_robot_path({0, 1}));
  grid.add_sweep({ray_of_cells({-9, 0}, {0, 0}, true)});
  EXPECT_TRUE(grid.is_robot_path({0, 0}));
}

TEST(HimmGrid, TurningTheRobotTurnsItsFootprint) {
  HimmGrid grid(0.1);
  grid.mark_robot({0.05, 0.05, kPi / 2.0}, {0.5, 0.1});
  EXPECT_TRUE(grid.is_robot_path({0, 2}));
  EXPECT_FALSE(grid.is_robot_path({2, 0}));
}

TEST(HimmGrid, AgreesWithAMapOfDoublesOnRandomSweeps) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> coordinate(-80, 80);
  HimmGrid grid(0.1);
  std::map<std::pair<int, int>, double> expected;
  const auto add = [&](Cell cell, double step) {
    double& value = expected[{cell.x, cell.y}];
    value = std::clamp(value + step, -3.0, 15.0);
  };
  for (int i = 0; i < 300; ++i) {
    const Cell from{coordinate(random), coordinate(random)};
    const Cell to{coordinate(random), coordinate(random)};
    grid.add_sweep({ray_of_cells(from, to, true)});
    for_each_cell_on_line(from, to, [&](const Cell& cell) {
      if (std::max(std::abs(cell.x - to.x), std::abs(cell.y - to.y)) <= 1) return false;
      add(cell, -1.0);
      return true;
    });
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) add({to.x + dx, to.y + dy}, dx == 0 && dy == 0 ? 3 : 1.5);
    }
  }
  for (const auto& [cell, value] : expected)
    EXPECT_EQ(grid.value({cell.first, cell.second}), value);
}

TEST(BresenhamLine, HasOneCellForEachStepOfTheLongerAxisAndStaysWithinHalfACell) {
  for (const Cell to : {Cell{7, 3}, {-7, 3}, {2, -9}, {0, 5}, {-4, -4}, {0, 0}}) {
    int count = 0;
    for_each_cell_on_line({0, 0}, to, [&](const Cell& cell) {
      const double length = std::max(1.0, std::hypot(to.x, to.y));
      EXPECT_LE(std::abs(cell.x * to.y - cell.y * to.x) / length, 0.5 + 1e-9);
      ++count;
      return true;
    });
    EXPECT_EQ(count, std::max(std::abs(to.x), std::abs(to.y)) + 1);
  }
}

/// As Bresenham's algorithm for all octants is mostly written: a branch for each axis.
std::vector<Cell> literal_line(Cell from, const Cell& to) {
  const int dx = std::abs(to.x - from.x);
  const int dy = -std::abs(to.y - from.y);
  int error = dx + dy;
  std::vector<Cell> cells{from};
  while (from != to) {
    const int doubled = 2 * error;
    if (doubled >= dy) {
      error += dy;
      from.x += from.x < to.x ? 1 : -1;
    }
    if (doubled <= dx) {
      error += dx;
      from.y += from.y < to.y ? 1 : -1;
    }
    cells.push_back(from);
  }
  return cells;
}

TEST(BresenhamLine, HasTheCellsOfTheLiteralAlgorithmButTheLast) {
  const Cell from{3, -2};
  for_each_cell({{-30, -30}, {31, 31}}, [&](const Cell& off) {
    std::vector<Cell> expected = literal_line(from, {from.x + off.x, from.y + off.y});
    for (int but = 0; but < 4; ++but) {
      std::vector<Cell> cells;
      const auto visit = [&](const Cell& cell) {
        cells.push_back(cell);
        return true;
      };
      for_each_cell_on_line(from, {from.x + off.x, from.y + off.y}, visit, but);
      ASSERT_EQ(cells, expected) << off.x << ' ' << off.y << " but " << but;
      if (!expected.empty()) expected.pop_back();
    }
  });
}

TEST(RaysOf, CutsAtTheMappedRangeAndCountsWhatIsNoMeasurement) {
  RangeSensor sensor;
  sensor.max_range_m = 5.0;
  sensor.robot_from_beam.assign(6, Pose2{0.1, 0.0, 0.0});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const RangeReading reading{
      0.0, {}, std::make_shared<RangeSensor>(sensor), {1.0F, 4.5F, 5.0F, nan, infinity, 0.0F}};
  std::int64_t ignored = 0;
  const std::vector<Ray> rays = rays_of(reading, {1.0, 0.0, 0.0}, {4.0, 1.0, 4.0}, ignored);
  ASSERT_EQ(rays.size(), 3U);
  EXPECT_EQ(ignored, 3);
  EXPECT_NEAR(rays[0].segment.b.x(), 2.1, 1e-6);
  EXPECT_TRUE(rays[0].ends_at_obstacle);
  EXPECT_NEAR(rays[1].segment.b.x(), 5.1, 1e-6);
  EXPECT_FALSE(rays[1].ends_at_obstacle);
  EXPECT_FALSE(rays[2].ends_at_obstacle);
}

TEST(RaysOf, WithoutEchoASonarFreesLittleAndALaserMore) {
  RangeSensor sensor;
  sensor.max_range_m = 5.0;
  sensor.robot_from_beam.assign(1, Pose2{});
  std::int64_t ignored = 0;
  const auto reach = [&](SensorKind kind) {
    sensor.kind = kind;
    const RangeReading reading{0.0, {}, std::make_shared<RangeSensor>(sensor), {5.0F}};
    return rays_of(reading, {}, {8.0, 1.0, 3.0}, ignored).at(0).segment.b.x();
  };
  EXPECT_DOUBLE_EQ(reach(SensorKind::sonar), 1.0);
  EXPECT_DOUBLE_EQ(reach(SensorKind::laser), 3.0);
}

}  // namespace
}  // namespace roomatlas
