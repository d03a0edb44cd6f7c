// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/clean_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "polyline/drawing.hpp"
#include "polyline/scanned_room.hpp"

namespace roomatlas {
namespace {

using namespace testing_polyline;

Drawing cleaned(const Drawing& drawing, const CleanOptions& options = {}) {
  return drawn(clean_map(grid_of(drawing), options), box_of(drawing));
}

TEST(Drawing, ReadsBackFromTheGridThatItMakes) {
  const Drawing room = {"## #", "#.r#", "  r "};
  const HimmGrid grid = grid_of(room);
  EXPECT_EQ(grid.value({0, 1}), 15.0);
  EXPECT_EQ(grid.value({1, 1}), -3.0);
  EXPECT_LT(grid.value({0, 0}), 1.0);
  EXPECT_GE(grid.value({0, 0}), 0.0);
  EXPECT_TRUE(grid.is_robot_path({2, 0}));
  EXPECT_EQ(drawn(map_of(room), box_of(room)), room);
  EXPECT_EQ(drawn(mask_of({".#", "#."})), (Drawing{".#", "#."}));
}

TEST(CleanMap, KeepsOnlyTheFrontLayerOfTheWallsOnBothSidesOfTheRoom) {
  EXPECT_EQ(cleaned({"###.....###",  //
                     "###.....###",  //
                     "###..r..###",  //
                     "###.....###",  //
                     "###.....###"}),
            (Drawing{"  #.....#  ",  //
                     "  #.....#  ",  //
                     "  #..r..#  ",  //
                     "  #.....#  ",  //
                     "  #.....#  "}));
}

TEST(CleanMap, KeepsBothFacesOfAWallThatTheRobotPassedOnEitherSide) {
  EXPECT_EQ(cleaned({"..###..",  //
                     "r.###.r",  //
                     "..###.."}),
            (Drawing{"..# #..",  //
                     "r.# #.r",  //
                     "..# #.."}));
}

TEST(CleanMap, ForgetsWhatLiesBehindAWallWhetherOccupiedOrEmpty) {
  EXPECT_EQ(cleaned({"......#..#",  //
                     "..r...#..#",  //
                     "......#..#"}),
            (Drawing{"......#   ",  //
                     "..r...#   ",  //
                     "......#   "}));
}

TEST(CleanMap, SeesThroughAGapAsFarAsLinesOfCellsReach) {
  EXPECT_EQ(cleaned({"....#.....",  //
                     "....#.....",  //
                     "..r.......",  //
                     "....#.....",  //
                     "....#....."}),
            (Drawing{"....#     ",  //
                     "....# ....",  //
                     "..r.......",  //
                     "....# ....",  //
                     "....#     "}));
}

TEST(CleanMap, ForgetsWhatIsFartherFromThePathThanTheRange) {
  EXPECT_EQ(cleaned({"r.....#"}, {.max_range_m = 0.5}), (Drawing{"r..... "}));
  EXPECT_EQ(cleaned({"r.....#"}, {.max_range_m = 0.6}), (Drawing{"r.....#"}));
}

TEST(CleanMap, KeepsThePathEvenBetweenWalls) {
  EXPECT_EQ(cleaned({"####", "#rr#", "####"}, {.thin = false}), (Drawing{"####", "#rr#", "####"}));
}

TEST(CleanMap, IsUnknownEverywhereWithoutPath) {
  const CellMap map = clean_map(grid_of({"#####", "#...#", "#####"}), {});
  EXPECT_EQ(map.count(CellState::unknown), static_cast<std::int64_t>(map.box.count()));
}

TEST(CleanMap, OfAnEmptyGridIsEmpty) { EXPECT_TRUE(clean_map(HimmGrid(0.1), {}).states.empty()); }

TEST(CleanMap, TakesOnlyCertaintyAboveEpsilonForOccupied) {
  HimmGrid grid = grid_of({"r......"});
  const Point2 hit = grid.frame().center_of({5, 0});
  for (int i = 0; i < 4; ++i) grid.add_sweep({{{hit, hit}, true}});
  ASSERT_EQ(grid.value({5, 0}), 9.0);  // 4 hits of 3, less the 3 of the empty cell
  EXPECT_EQ(clean_map(grid, {.epsilon = 8.9}).at({5, 0}), CellState::occupied);
  EXPECT_EQ(clean_map(grid, {.epsilon = 9.0}).at({5, 0}), CellState::unknown);
}

TEST(CleanMap, BreaksABlockByTakingTheCellFarthestFromThePath) {
  EXPECT_EQ(cleaned({".....r",  //
                     "r.##..",  //
                     "r.##..",  //
                     "......"}),
            (Drawing{".....r",  //
                     "r.##..",  //
                     "r.# ..",  //
                     "......"}));
}

/// Squared distance in cells to the nearest path, over all cells of the path.
int squared_distance_to_path(const CellMap& map, const Cell& from) {
  int nearest = std::numeric_limits<int>::max();
  for_each_cell(map.box, [&](const Cell& cell) {
    if (map.at(cell) != CellState::robot_path) return;
    const int dx = cell.x - from.x;
    const int dy = cell.y - from.y;
    nearest = std::min(nearest, dx * dx + dy * dy);
  });
  return nearest;
}

/// Calls `visit` with the four cells of each 2 x 2 block of occupied cells.
template <typename Visit>
void for_each_block(const CellMap& map, Visit visit) {
  for_each_cell(map.box, [&](const Cell& c) {
    const std::vector<Cell> block = {c, {c.x + 1, c.y}, {c.x, c.y + 1}, {c.x + 1, c.y + 1}};
    for (const Cell& cell : block) {
      if (map.at(cell) != CellState::occupied) return;
    }
    visit(block);
  });
}

TEST(CleanMap, ThinsUntilNoBlockOfFourIsLeftAndTakesNothingElse) {
  std::mt19937 random(5);
  for (int round = 0; round < 30; ++round) {
    const HimmGrid grid = grid_of(random_drawing(random, 24, 24, "####......r"));
    const CellMap thick = clean_map(grid, {.thin = false});
    const CellMap thin = clean_map(grid, {.thin = true});
    for_each_block(thin, [](const std::vector<Cell>&) { ADD_FAILURE() << "a block is left"; });
    CellMask may_go(thick.box);  // the cells that no other cell of some block is farther than
    for_each_block(thick, [&](const std::vector<Cell>& block) {
      int farthest = 0;
      for (const Cell& c : block) farthest = std::max(farthest, squared_distance_to_path(thick, c));
      for (const Cell& c : block) {
        if (squared_distance_to_path(thick, c) == farthest) may_go.set(c, true);
      }
    });
    for_each_cell(thick.box, [&](const Cell& cell) {
      if (thin.at(cell) == thick.at(cell)) return;
      EXPECT_TRUE(may_go.at(cell));
      EXPECT_EQ(thin.at(cell), CellState::unknown);
    });
  }
}

TEST(CleanMap, KeepsTheCellOfEachBlockOfAnOfficeThatIsNearestToThePath) {
  const HimmGrid grid = scanned(office_walls(), office_drive(), {.noise_m = 0.02});
  const CellMap thick = clean_map(grid, {.thin = false});
  const CellMap thin = clean_map(grid, {.thin = true});
  int blocks = 0;
  for_each_block(thick, [&](const std::vector<Cell>& block) {
    ++blocks;
    int nearest = std::numeric_limits<int>::max();
    for (const Cell& c : block) nearest = std::min(nearest, squared_distance_to_path(thick, c));
    EXPECT_TRUE(std::any_of(block.begin(), block.end(),
                            [&](const Cell& c) {
                              return squared_distance_to_path(thick, c) == nearest &&
                                     thin.at(c) == CellState::occupied;
                            }))
        << block.front().x << ", " << block.front().y;
  });
  EXPECT_GT(blocks, 3);
}

TEST(CleanMap, ChangesNothingMoreWhenItsResultIsCleanedAgain) {
  std::mt19937 random(6);
  for (int round = 0; round < 30; ++round) {
    const Drawing once = cleaned(random_drawing(random, 24, 24, "###.......  r"));
    EXPECT_EQ(cleaned(once), once);
  }
}

}  // namespace
}  // namespace roomatlas
