// SPDX-License-Identifier: GPL-3.0-or-later
// CleanMap against the literal loop of the paper's Fig. 5.
#include <gtest/gtest.h>

#include <random>

#include "polyline/drawing.hpp"
#include "polyline/literal_clean_map.hpp"
#include "polyline/scanned_room.hpp"

namespace roomatlas {
namespace {

using namespace testing_polyline;

constexpr double kEpsilon = 7.0;

CellMap shipped(const HimmGrid& grid, int range_cells) {
  return clean_map(grid, {kEpsilon, range_cells * 0.1, false});
}

/// How a cleaned map differs from the literal result, in cells.
struct Difference {
  int occupied = 0;        ///< occupied in the literal result
  int empty = 0;           ///< empty in the literal result
  int lost_occupied = 0;   ///< of these, unknown in ours
  int lost_empty = 0;      ///< of these, unknown in ours
  int contradictions = 0;  ///< anything else: there must be none

  [[nodiscard]] int lost() const { return lost_occupied + lost_empty; }
};

void compare(const CellMap& ours, const CellMap& literal, Difference& sum) {
  ASSERT_EQ(ours.states.size(), literal.states.size());
  for_each_cell(literal.box, [&](const Cell& cell) {
    const CellState expected = literal.at(cell);
    const bool is_occupied = expected == CellState::occupied;
    const bool is_empty = expected == CellState::empty;
    const bool is_lost = ours.at(cell) == CellState::unknown && (is_occupied || is_empty);
    sum.occupied += is_occupied;
    sum.empty += is_empty;
    sum.lost_occupied += is_lost && is_occupied;
    sum.lost_empty += is_lost && is_empty;
    sum.contradictions += !is_lost && ours.at(cell) != expected;
  });
}

void record(const Difference& found) {
  testing::Test::RecordProperty("literal_occupied_cells", found.occupied);
  testing::Test::RecordProperty("literal_empty_cells", found.empty);
  testing::Test::RecordProperty("lost_occupied_cells", found.lost_occupied);
  testing::Test::RecordProperty("lost_empty_cells", found.lost_empty);
}

void expect_hardly_a_difference(const Scanner& scanner) {
  const HimmGrid grid = scanned(office_walls(), office_drive(), scanner);
  Difference found;
  compare(shipped(grid, 50), literal_clean_map(grid, kEpsilon, 50), found);
  record(found);
  EXPECT_EQ(found.contradictions, 0);
  EXPECT_GT(found.occupied, 300);
  EXPECT_GT(found.empty, 2500);
  EXPECT_LE(found.lost(), 4);
}

TEST(CleanMapAgainstFig5, LosesHardlyACellOfAnOfficeScannedByALaser) {
  expect_hardly_a_difference({.noise_m = 0.02});
}

TEST(CleanMapAgainstFig5, LosesHardlyACellOfAnOfficeScannedBySonars) {
  expect_hardly_a_difference({.beams = 16, .fan_rad = 1.875 * kPi, .noise_m = 0.05});
}

TEST(CleanMapAgainstFig5, LosesFewCellsOfRandomClutterAndAddsNone) {
  std::mt19937 random(11);
  Difference found;
  for (const std::string letters : {"#....  r", "###...... r", "#..................r"}) {
    for (int round = 0; round < 10; ++round) {
      const HimmGrid grid = grid_of(random_drawing(random, 30, 24, letters));
      compare(shipped(grid, 9), literal_clean_map(grid, kEpsilon, 9), found);
    }
  }
  record(found);
  EXPECT_EQ(found.contradictions, 0);
  EXPECT_LE(found.lost(), (found.occupied + found.empty) / 100);
}

TEST(CleanMap, KeepsExactlyTheCellsFromWhichALineToTheRimOfThePathIsClear) {
  std::mt19937 random(12);
  for (const std::string letters : {"#...r", "##....  rrr", "##...rrrrrrrrrr", "#..rrrrrrrrrrrr"}) {
    for (int round = 0; round < 20; ++round) {
      const HimmGrid grid = grid_of(random_drawing(random, 24, 24, letters));
      const CellMap expected = clean_map_by_goals(grid, kEpsilon, 8, path_cells(grid, true));
      EXPECT_EQ(shipped(grid, 8).states, expected.states);
    }
  }
}

TEST(CleanMapAgainstFig5, LosesACellFromWhichOnlyARayPastThePathCrossesIt) {
  const Drawing room = {"  ",  //
                        " r",  //
                        " #",  //
                        "  ",  //
                        "  ",  //
                        ". "};
  const HimmGrid grid = grid_of(room);
  EXPECT_EQ(drawn(literal_clean_map(grid, kEpsilon, 8), box_of(room))[5], ". ");
  EXPECT_EQ(drawn(shipped(grid, 8), box_of(room))[5], "  ");
}

TEST(CleanMap, LosesACellFromWhichOnlyALineToTheInsideOfThePathIsClear) {
  const Drawing room = {"     .",  //
                        "      ",  //
                        "  #   ",  //
                        " r #  ",  //
                        "rrr   ",  //
                        " r    "};
  const HimmGrid grid = grid_of(room);
  const CellMap every = clean_map_by_goals(grid, kEpsilon, 6, path_cells(grid, false));
  EXPECT_EQ(drawn(every, box_of(room)), room);
  EXPECT_EQ(drawn(shipped(grid, 6), box_of(room))[0], "      ");
}

TEST(CleanMap, LosesNoCellOfAnOfficeByAskingTheRimOfThePathAlone) {
  const HimmGrid grid = scanned(office_walls(), office_drive(), {.noise_m = 0.02});
  const CellMap every = clean_map_by_goals(grid, kEpsilon, 50, path_cells(grid, false));
  EXPECT_EQ(shipped(grid, 50).states, every.states);
}

}  // namespace
}  // namespace roomatlas
