// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/extract_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "polyline/drawing.hpp"
#include "polyline/scanned_room.hpp"

namespace roomatlas {
namespace {

using namespace testing_polyline;

std::vector<CellChain> chains_of(const Drawing& drawing, double gamma_cells = 4.0) {
  return extract_points(map_of(drawing), gamma_cells);
}

/// Follows a chain from `from` towards `to` and checks each step against all cells left: the next
/// cell must be the nearest of them, and none may be within gamma of the end.
template <typename Iterator>
void expect_nearest_steps(Iterator from, Iterator to, std::vector<Cell>& left, double gamma) {
  const auto nearest_left = [&](const Cell& at) {
    double nearest = 1e9;
    for (const Cell& cell : left) nearest = std::min(nearest, distance_cells(at, cell));
    return nearest;
  };
  for (Iterator at = from;; ++at) {
    const double nearest = nearest_left(*at);
    if (at + 1 == to) {
      EXPECT_GT(nearest, gamma);
      return;
    }
    EXPECT_LE(nearest, gamma);
    EXPECT_EQ(distance_cells(*at, *(at + 1)), nearest);
    const auto place = std::find(left.begin(), left.end(), *(at + 1));
    ASSERT_NE(place, left.end());
    left.erase(place);
  }
}

TEST(ExtractPoints, StepsToTheNearestCellLeftAndTakesEachOnceByBruteForce) {
  std::mt19937 random(21);
  for (const double gamma : {1.0, 1.5, 2.0, 4.0}) {
    for (int round = 0; round < 25; ++round) {
      const CellMap map = map_of(random_drawing(random, 20, 20, "#........"));
      std::vector<Cell> left;
      for_each_cell(map.box, [&](const Cell& cell) {
        if (map.at(cell) == CellState::occupied) left.push_back(cell);
      });
      for (const CellChain& chain : extract_points(map, gamma)) {
        ASSERT_FALSE(left.empty());
        const auto start = std::find(chain.begin(), chain.end(), left.front());
        ASSERT_NE(start, chain.end()) << "the chain does not begin at the first cell left";
        left.erase(left.begin());
        expect_nearest_steps(start, chain.end(), left, gamma);
        expect_nearest_steps(std::make_reverse_iterator(start + 1), chain.rend(), left, gamma);
      }
      EXPECT_TRUE(left.empty());
    }
  }
}

TEST(ExtractPoints, BridgesAGapOfGammaAndSplitsAtALargerOne) {
  EXPECT_EQ(chains_of({"##...##"}, 4.0).size(), 1U);
  EXPECT_EQ(chains_of({"##....##"}, 4.0).size(), 2U);
  EXPECT_EQ(chains_of({"...#",  //
                       "....",  //
                       "....",  //
                       "....",  //
                       "#..."},
                      5.0)
                .size(),
            1U);
  EXPECT_EQ(chains_of({"...#", "....", "....", "....", "#..."}, 4.99).size(), 2U);
}

TEST(ExtractPoints, GivesOneChainForAWallThatItEntersInItsMiddle) {
  const auto chains = chains_of({"#.....#",  //
                                 ".#...#.",  //
                                 "..#.#..",  //
                                 "...#..."},
                                1.5);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].size(), 7U);
  EXPECT_THAT((std::vector<Cell>{chains[0].front(), chains[0].back()}),
              testing::UnorderedElementsAre(Cell{0, 3}, Cell{6, 3}));
  EXPECT_EQ(chains[0][3], (Cell{3, 0}));
}

TEST(ExtractPoints, FollowsAClosedRoomAroundInOneChain) {
  const auto chains = chains_of({".####.",  //
                                 "#....#",  //
                                 "#....#",  //
                                 ".####."},
                                1.5);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].size(), 12U);
  EXPECT_LE(distance_cells(chains[0].front(), chains[0].back()), 1.5);
}

TEST(ExtractPoints, KeepsTwoWallsThatAreFarApartInTwoChains) {
  const auto chains = chains_of({"######",  //
                                 "......",  //
                                 "......",  //
                                 "######"},
                                2.0);
  ASSERT_EQ(chains.size(), 2U);
  EXPECT_THAT(chains[0], testing::Each(testing::Field(&Cell::y, 0)));
  EXPECT_THAT(chains[1], testing::Each(testing::Field(&Cell::y, 3)));
}

TEST(ExtractPoints, IgnoresEverythingThatIsNotOccupied) {
  EXPECT_TRUE(chains_of({"..r ", " ..."}).empty());
  EXPECT_TRUE(chains_of({}).empty());
}

TEST(ExtractPoints, GivesTheSameChainsTwice) {
  std::mt19937 random(22);
  const CellMap map = map_of(random_drawing(random, 40, 40, "#...."));
  EXPECT_EQ(extract_points(map, 4.0), extract_points(map, 4.0));
}

/// A straight wall seen head on: 60 sweeps of parallel beams that end at x = 2.03.
HimmGrid wall_at_2_03() {
  HimmGrid grid(0.1);
  for (int sweep = 0; sweep < 60; ++sweep) {
    std::vector<Ray> rays;
    for (int i = 0; i <= 100; ++i) {
      const double y = 0.01 + 0.03 * i;
      rays.push_back({{{0.5, y}, {2.03, y}}, true});
    }
    grid.add_sweep(rays);
  }
  grid.mark_robot({0.5, 1.5, kPi / 2.0}, {3.0, 0.4});
  return grid;
}

TEST(ChainPoints, RefinedLieWithinTwoCentimetresOfAStraightWallAndCellCentresDoNot) {
  const HimmGrid grid = wall_at_2_03();
  const CleanOptions options;
  const auto chains = extract_points(clean_map(grid, options), 4.0);
  ASSERT_EQ(chains.size(), 1U);
  ASSERT_GT(chains[0].size(), 25U);
  const auto refined = chain_points(chains, grid, options.epsilon, true);
  const auto centres = chain_points(chains, grid, options.epsilon, false);
  ASSERT_EQ(refined[0].size(), chains[0].size());
  for (std::size_t i = 0; i < chains[0].size(); ++i) {
    EXPECT_EQ(centres[0][i], grid.frame().center_of(chains[0][i]));
    EXPECT_EQ(refined[0][i], refined_point(chains[0][i], grid, options.epsilon));
    EXPECT_LE(std::abs(refined[0][i].x() - 2.03), 0.02 + 1e-9);
    EXPECT_GT(std::abs(centres[0][i].x() - 2.03), 0.02);
  }
}

TEST(ChainPoints, RefinedLieNearerToTheWallsOfAnOfficeThanCellCentres) {
  const HimmGrid grid = scanned(office_walls(), office_drive(), {.noise_m = 0.01});
  const CleanOptions options;
  const auto chains = extract_points(clean_map(grid, options), 4.0);
  const auto mean_error = [&](bool refine) {
    double sum_m = 0.0;
    double count = 0.0;
    for (const Polyline& line : chain_points(chains, grid, options.epsilon, refine)) {
      for (const Point2& point : line) {
        double nearest_m = 1e9;
        for (const Segment2& wall : office_walls()) {
          nearest_m = std::min(nearest_m, distance(wall, point));
        }
        sum_m += nearest_m;
        count += 1.0;
      }
    }
    return sum_m / count;
  };
  EXPECT_LT(mean_error(true), 0.05);
  EXPECT_LT(mean_error(true), 0.6 * mean_error(false));
}

TEST(ChainPoints, RefinedToTheCentreOfACellWithoutCertainty) {
  const HimmGrid grid(0.1);
  EXPECT_EQ(refined_point({3, 4}, grid, 7.0), grid.frame().center_of({3, 4}));
}

}  // namespace
}  // namespace roomatlas
