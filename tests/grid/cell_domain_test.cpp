// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/grid/cell_domain.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "roomatlas/grid/reflection_map.hpp"
#include "support/spotty_domain.hpp"

namespace roomatlas {
namespace {

TEST(CellDomain, ABoxIsNumberedRowByRow) {
  const CellBox box{{-2, 3}, {4, 7}};
  const CellDomain domain(box);
  EXPECT_EQ(domain.count(), 24U);
  std::size_t next = 0;
  for_each_cell(domain, [&](const Cell& cell) { EXPECT_EQ(domain.find(cell), next++); });
  EXPECT_EQ(next, domain.count());
  EXPECT_FALSE(domain.contains({4, 3}));
  EXPECT_TRUE(domain.is_at_rim({-2, 4}));
  EXPECT_FALSE(domain.is_at_rim({0, 4}));
}

TEST(CellDomain, CellsAreNumberedAsTheyAreVisitedAndOthersAreNot) {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    const CellBox box{{-9, -4}, {30, 15}};
    const CellDomain domain = test::spotty_domain(random, box);
    std::vector<bool> is_visited(box.count(), false);
    std::size_t next = 0;
    for_each_cell(domain, [&](const Cell& cell) {
      ASSERT_EQ(domain.find(cell), next++);
      ASSERT_TRUE(domain.bounds().contains(cell));
      is_visited[box.index_of(cell)] = true;
    });
    EXPECT_EQ(next, domain.count());
    for_each_cell(box, [&](const Cell& cell) {
      EXPECT_EQ(domain.contains(cell), is_visited[box.index_of(cell)]);
    });
  }
}

TEST(CellDomain, WithinABoxAreTheCellsThatBothHave) {
  std::mt19937 random(6);
  const CellBox box{{-9, -4}, {30, 15}};
  const CellDomain domain = test::spotty_domain(random, box);
  const CellBox part{{-3, 1}, {12, 40}};
  const CellDomain within = domain.within(part);
  for_each_cell({{-12, -8}, {34, 44}}, [&](const Cell& cell) {
    EXPECT_EQ(within.contains(cell), domain.contains(cell) && part.contains(cell));
  });
  EXPECT_EQ(domain.within({{100, 100}, {110, 110}}).count(), 0U);
  EXPECT_TRUE(CellDomain(box).within(part) == CellDomain(CellBox{{-3, 1}, {12, 15}}));
  EXPECT_TRUE(domain == domain.within(box));
  EXPECT_FALSE(domain == within);
}

TEST(CellDomain, WithoutCellsIsEmpty) {
  EXPECT_EQ(CellDomain().count(), 0U);
  EXPECT_FALSE(CellDomain().contains({0, 0}));
  EXPECT_EQ(CellDomain::from_rows(7, {{}, {}}).count(), 0U);
}

/// A corridor along a diagonal, drawn by short rays.
ReflectionMap diagonal(int cells) {
  ReflectionMap map(0.05);
  for (int i = 0; i < cells; ++i) {
    const Point2 at = 0.05 * Point2(i, i);
    map.add_sweep({{{at, at + Point2(0.6, -0.6)}, true}, {{at, at + Point2(-0.6, 0.6)}, true}});
  }
  return map;
}

TEST(DomainOfAMap, IsItsBoxWhereMuchOfThatWasSeen) {
  ReflectionMap map(0.05);
  for (int i = 0; i < 200; ++i) map.add_sweep({{{{0.0, 0.05 * i}, {9.0, 0.05 * i}}, true}});
  const CellBox box = map.box();
  EXPECT_TRUE(map.domain(3) ==
              CellDomain(CellBox{{box.min.x - 3, box.min.y - 3}, {box.max.x + 3, box.max.y + 3}}));
}

TEST(DomainOfAMap, FollowsWhatWasSeenWhereMostOfTheBoxIsEmpty) {
  const ReflectionMap shorter = diagonal(2000);
  const ReflectionMap longer = diagonal(4000);
  const CellDomain domain = longer.domain(4);
  for_each_cell(longer.box(), [&](const Cell& cell) {
    if (longer.at(cell).is_seen()) {
      ASSERT_TRUE(domain.contains(cell));
    }
  });
  EXPECT_LT(domain.count(), longer.box().count() / 8);
  EXPECT_NEAR(static_cast<double>(domain.count()),
              2.0 * static_cast<double>(shorter.domain(4).count()),
              0.1 * static_cast<double>(domain.count()));
}

TEST(DomainOfAMap, HasGapsWhole) {
  // A ring of 5 m around what nobody saw, in a building that is mostly empty.
  ReflectionMap map = diagonal(3000);
  for (double angle_rad = 0.0; angle_rad < 2.0 * kPi; angle_rad += 0.002) {
    const Point2 out = direction(angle_rad);
    map.add_sweep({{{Point2(100, 20) + 2.5 * out, Point2(100, 20) + 2.7 * out}, true}});
  }
  const CellDomain domain = map.domain(4);
  ASSERT_LT(domain.count(), map.box().count() / 5);
  for_each_cell({{1950, 350}, {2050, 450}}, [&](const Cell& cell) {
    EXPECT_TRUE(domain.contains(cell)) << cell.x << ' ' << cell.y;
  });
}

}  // namespace
}  // namespace roomatlas
