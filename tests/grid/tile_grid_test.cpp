// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/grid/tile_grid.hpp"
#include "roomatlas/correct/place.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <utility>

namespace roomatlas {
namespace {

constexpr int kTile = 16;  // cells a side
using Key = std::pair<int, int>;

Key key(const Cell& cell) { return {cell.x, cell.y}; }

/// Rounded towards minus infinity.
int tile_number(int cell) { return cell >= 0 ? cell / kTile : -((kTile - 1 - cell) / kTile); }

/// A grid and a map that were given the same cells.
struct Written {
  TileGrid<int> grid;
  std::map<Key, int> expected;
  std::set<Key> tiles;

  void add(const Cell& cell, int value) {
    grid.edit(cell) += value;
    expected[key(cell)] += value;
    tiles.insert({tile_number(cell.x), tile_number(cell.y)});
  }
};

/// Walks in a random direction from random places, so that tables grow to every side.
Written random_cells(unsigned seed, int walks) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> place(-300, 300);
  std::uniform_int_distribution<int> step(-3, 3);
  std::uniform_int_distribution<int> value(1, 9);
  Written written;
  for (int walk = 0; walk < walks; ++walk) {
    Cell at{place(random), place(random)};
    for (int i = 0; i < 40; ++i) {
      written.add(at, value(random));
      at = {at.x + step(random), at.y + step(random)};
    }
  }
  return written;
}

TEST(TileGrid, HoldsWhatAMapHoldsAndNothingElse) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Written written = random_cells(seed, 60);
    for_each_cell({{-460, -460}, {460, 460}}, [&](const Cell& cell) {
      const auto found = written.expected.find(key(cell));
      const int expected = found == written.expected.end() ? 0 : found->second;
      ASSERT_EQ(written.grid.at(cell), expected) << cell.x << " " << cell.y;
    });
  }
}

TEST(TileGrid, ReadsUnwrittenCellsAsTheirDefaultHoweverFar) {
  struct Marked {
    int mark = 7;
  };
  TileGrid<Marked> grid;
  EXPECT_EQ(grid.at({0, 0}).mark, 7);
  grid.edit({-1, -1}).mark = 1;
  EXPECT_EQ(grid.at({-1, -1}).mark, 1);
  EXPECT_EQ(grid.at({-2, -1}).mark, 7);
  EXPECT_EQ(grid.at({1000000, -1000000}).mark, 7);
}

TEST(TileGrid, BoxIsThatOfTheTilesWritten) {
  EXPECT_EQ(TileGrid<int>{}.box().count(), 0U);
  for (const unsigned seed : {4U, 5U}) {
    const Written written = random_cells(seed, 3);
    int min_x = 1000;
    int min_y = 1000;
    int max_x = -1000;
    int max_y = -1000;
    for (const auto& [x, y] : written.tiles) {
      min_x = std::min(min_x, x);
      min_y = std::min(min_y, y);
      max_x = std::max(max_x, x);
      max_y = std::max(max_y, y);
    }
    const CellBox box = written.grid.box();
    EXPECT_EQ(key(box.min), Key(min_x * kTile, min_y * kTile));
    EXPECT_EQ(key(box.max), Key((max_x + 1) * kTile, (max_y + 1) * kTile));
  }
}

TEST(TileGrid, VisitsEveryCellOfWrittenTilesOnceTilesAndCellsRowByRow) {
  const Written written = random_cells(6, 20);
  std::vector<Cell> visited;
  written.grid.for_each([&](const Cell& cell, int value) {
    visited.push_back(cell);
    const auto found = written.expected.find(key(cell));
    ASSERT_EQ(value, found == written.expected.end() ? 0 : found->second);
  });
  std::vector<Key> expected;
  std::set<Key> tiles_by_row;  // y first
  for (const auto& [x, y] : written.tiles) tiles_by_row.insert({y, x});
  for (const auto& [y, x] : tiles_by_row) {
    for (int row = 0; row < kTile; ++row) {
      for (int column = 0; column < kTile; ++column) {
        expected.emplace_back(x * kTile + column, y * kTile + row);
      }
    }
  }
  ASSERT_EQ(visited.size(), expected.size());
  for (std::size_t i = 0; i < visited.size(); ++i) ASSERT_EQ(key(visited[i]), expected[i]);
}

}  // namespace
}  // namespace roomatlas
