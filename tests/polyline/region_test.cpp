// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/region.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "polyline/drawing.hpp"
#include "roomatlas/polyline/small_part.hpp"
#include "support/spotty_domain.hpp"

namespace roomatlas {
namespace {

using namespace testing_polyline;

TEST(Dilated, GrowsBySquaresAndStaysInTheBox) {
  EXPECT_EQ(drawn(dilated(mask_of({"......",  //
                                   "......",  //
                                   "...#..",  //
                                   "......",  //
                                   "#....."}),
                          1)),
            (Drawing{"......",  //
                     "..###.",  //
                     "..###.",  //
                     "#####.",  //
                     "##...."}));
}

TEST(Eroded, ShrinksBySquaresAndCountsWhatIsOutsideOfTheBoxAsOutside) {
  EXPECT_EQ(drawn(eroded(mask_of({"#####.",  //
                                  "#####.",  //
                                  "#####.",  //
                                  "####..",  //
                                  "####.."}),
                         1)),
            (Drawing{"......",  //
                     ".###..",  //
                     ".##...",  //
                     ".##...",  //
                     "......"}));
}

/// How many cells of the square around `cell` belong to the mask.
int count_in_square(const CellMask& mask, const Cell& cell, int radius) {
  int count = 0;
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) count += mask.at({cell.x + dx, cell.y + dy});
  }
  return count;
}

TEST(DilatedAndEroded, AgreeWithCountingTheSquareAroundEachCell) {
  std::mt19937 random(51);
  for (const std::string letters : {"#.........", "#########."}) {
    for (int radius = 0; radius <= 3; ++radius) {
      const CellMask mask = mask_of(random_drawing(random, 23, 17, letters));
      const CellMask grown = dilated(mask, radius);
      const CellMask shrunk = eroded(mask, radius);
      const int all = (2 * radius + 1) * (2 * radius + 1);
      for_each_cell(mask.domain, [&](const Cell& cell) {
        const int count = count_in_square(mask, cell, radius);
        EXPECT_EQ(grown.at(cell), count > 0);
        EXPECT_EQ(shrunk.at(cell), count == all);
      });
    }
  }
}

TEST(DilatedAndEroded, DoSoOnADomainThatIsNoBox) {
  std::mt19937 random(52);
  for (const unsigned one_of : {2U, 12U}) {
    for (int radius = 0; radius <= 3; ++radius) {
      CellMask mask(test::spotty_domain(random, {{-3, -5}, {40, 25}}));
      for_each_cell(mask.domain,
                    [&](const Cell& cell) { mask.set(cell, random() % one_of != 0U); });
      const CellMask grown = dilated(mask, radius);
      const CellMask shrunk = eroded(mask, radius);
      const int all = (2 * radius + 1) * (2 * radius + 1);
      for_each_cell(mask.domain, [&](const Cell& cell) {
        ASSERT_EQ(shrunk.at(cell), count_in_square(mask, cell, radius) == all);
        int in_rows = 0;  // of the domain's own cells above and below
        for (int dy = -radius; dy <= radius; ++dy) {
          if (!mask.domain.contains({cell.x, cell.y + dy})) continue;
          for (int dx = -radius; dx <= radius; ++dx) in_rows += mask.at({cell.x + dx, cell.y + dy});
        }
        ASSERT_EQ(grown.at(cell), in_rows > 0);
      });
    }
  }
}

TEST(ConnectedTo, KeepsThePartsThatTouchASeedByEdges) {
  const CellMask mask = mask_of({"##..##",  //
                                 "#..#..",  //
                                 "...#..",  //
                                 "##...#"});
  EXPECT_EQ(drawn(connected_to(mask, {{0, 0}, {3, 1}})), (Drawing{"......",  //
                                                                  "...#..",  //
                                                                  "...#..",  //
                                                                  "##...."}));
  EXPECT_EQ(connected_to(mask, {}).count(), 0);
  EXPECT_EQ(connected_to(mask, {{2, 0}, {-5, 99}}).count(), 0) << "no seed lies in the mask";
}

TEST(ConnectedTo, AgreesWithSpreadingFromTheSeedUntilNothingChanges) {
  std::mt19937 random(52);
  for (int round = 0; round < 30; ++round) {
    const CellMask mask = mask_of(random_drawing(random, 20, 20, "###.."));
    CellMask expected(mask.domain);
    expected.set({10, 10}, mask.at({10, 10}));
    for (std::int64_t before = -1; before != expected.count();) {
      before = expected.count();
      for_each_cell(mask.domain, [&](const Cell& c) {
        const bool beside = expected.at({c.x - 1, c.y}) || expected.at({c.x + 1, c.y}) ||
                            expected.at({c.x, c.y - 1}) || expected.at({c.x, c.y + 1});
        if (mask.at(c) && beside) expected.set(c, true);
      });
    }
    EXPECT_EQ(drawn(connected_to(mask, {{10, 10}})), drawn(expected));
  }
}

TEST(HolesFilled, FillsHolesOfFewerCellsThanTheLimitAndNothingElse) {
  const CellMask mask = mask_of({"#######.",  //
                                 "#.##..#.",  //
                                 "#######.",  //
                                 "#...##..",  //
                                 "########"});
  EXPECT_EQ(drawn(holes_filled(mask, 3)), (Drawing{"#######.",  //
                                                   "#######.",  //
                                                   "#######.",  //
                                                   "#...##..",  //
                                                   "########"}));
  EXPECT_EQ(drawn(holes_filled(mask, 2)), (Drawing{"#######.",  //
                                                   "####..#.",  //
                                                   "#######.",  //
                                                   "#...##..",  //
                                                   "########"}));
  EXPECT_EQ(drawn(holes_filled(mask, 99)), (Drawing{"#######.",  //
                                                    "#######.",  //
                                                    "#######.",  //
                                                    "######..",  //
                                                    "########"}));
  EXPECT_EQ(drawn(holes_filled(mask, 0)), drawn(mask));
}

TEST(HolesFilled, TakesHolesThatTouchAtACornerForTwo) {
  const CellMask mask = mask_of({"#####",  //
                                 "#.###",  //
                                 "##..#",  //
                                 "#####"});
  EXPECT_EQ(drawn(holes_filled(mask, 2)), (Drawing{"#####",  //
                                                   "#####",  //
                                                   "##..#",  //
                                                   "#####"}));
}

TEST(HolesFilled, LeavesWhatReachesTheEdgeOfTheBoxOpen) {
  const Drawing bay = {"####",  //
                       "#..#",  //
                       "#.##"};
  EXPECT_EQ(drawn(holes_filled(mask_of(bay), 99)), bay);
}

TEST(CellMask, OfAnEmptyBoxStaysEmpty) {
  const CellMask none{CellBox{}};
  EXPECT_EQ(dilated(none, 2).count(), 0);
  EXPECT_EQ(eroded(none, 2).count(), 0);
  EXPECT_EQ(connected_to(none, {{0, 0}}).count(), 0);
  EXPECT_EQ(holes_filled(none, 9).count(), 0);
}

/// The cells that hang together with `start` over edges and corners: those of a mask that touch
/// one of them, until there are no more.
std::vector<Cell> hanging_together(const CellMask& mask, const Cell& start) {
  CellMask part(mask.domain);
  part.set(start, true);
  for (std::int64_t before = 0; before != part.count();) {
    before = part.count();
    for_each_cell(mask.domain, [&](const Cell& cell) {
      if (mask.at(cell) && count_in_square(part, cell, 1) > 0) part.set(cell, true);
    });
  }
  std::vector<Cell> cells;
  for_each_cell(part.domain, [&](const Cell& cell) {
    if (part.at(cell)) cells.push_back(cell);
  });
  return cells;
}

TEST(SmallPart, IsWhatHangsTogetherWhereThatIsFewCells) {
  std::mt19937 random(53);
  constexpr std::size_t kMost = 6;
  std::size_t large = 0;
  std::size_t small = 0;
  for (int round = 0; round < 20; ++round) {
    CellMask mask(test::spotty_domain(random, {{-5, -3}, {15, 11}}));
    for (auto& bit : mask.bits) bit = random() % 3 == 0 ? 1 : 0;
    CellMask is_done(mask.domain);
    for_each_cell(mask.domain, [&](const Cell& start) {
      if (!mask.at(start) || is_done.at(start)) return;
      std::vector<Cell> part = small_part(
          start, kMost, [&](const Cell& cell) { return mask.at(cell); }, is_done);
      const std::vector<Cell> all = hanging_together(mask, start);
      for (const Cell& cell : all) EXPECT_TRUE(is_done.at(cell));
      ++(all.size() > kMost ? large : small);
      std::sort(part.begin(), part.end(), [](const Cell& a, const Cell& b) {
        return std::pair(a.y, a.x) < std::pair(b.y, b.x);
      });
      EXPECT_EQ(part, all.size() > kMost ? std::vector<Cell>{} : all);
    });
    EXPECT_EQ(is_done.count(), mask.count());
  }
  EXPECT_GT(large, 10U);
  EXPECT_GT(small, 10U);
}

}  // namespace
}  // namespace roomatlas
