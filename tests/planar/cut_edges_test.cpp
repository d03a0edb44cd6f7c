// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/planar/predicates.hpp"
#include "planar/exact_crossing.hpp"
#include "roomatlas/planar/edges.hpp"

#include <gtest/gtest.h>

#include <random>

namespace roomatlas::planar {
namespace {

/// Edges between random points of a square.
EdgeSet random_edges(std::mt19937& random, int extent_mm, int count) {
  std::uniform_int_distribution<int> coordinate(0, extent_mm);
  EdgeSet set;
  PointNumbers numbers(set.points_mm, 2);
  const auto point = [&] {
    return numbers.number_of(Point2(coordinate(random), coordinate(random)));
  };
  for (int i = 0; i < count; ++i) {
    const RingEdge edge{point(), point(), i};
    if (edge.from != edge.to) set.edges.push_back(edge);
  }
  return set;
}

/// Whether edges meet in end points only, told by whole numbers.
bool meet_in_ends_only(const EdgeSet& set) {
  for (const RingEdge& e : set.edges) {
    const auto a = test::fine(set.point(e.from), set.fine);
    const auto b = test::fine(set.point(e.to), set.fine);
    for (const RingEdge& f : set.edges) {
      const auto c = test::fine(set.point(f.from), set.fine);
      const auto d = test::fine(set.point(f.to), set.fine);
      if (test::cross_inside(a, b, c, d) || test::is_inside_edge(a, b, c)) return false;
    }
  }
  return true;
}

TEST(CutEdges, CutsBothEdgesWhereTheyCross) {
  const EdgeSet cut =
      cut_where_they_meet({0x1p16, {{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {{0, 1, 0}, {2, 3, 1}}});
  EXPECT_EQ(cut.edges.size(), 4U);
  ASSERT_EQ(cut.points_mm.size(), 5U);
  EXPECT_EQ(cut.points_mm[4], Point2(1, 1));
}

TEST(CutEdges, CutsAnEdgeWhereAnotherEndsOnItAndWhereItOverlaps) {
  const EdgeSet touched =
      cut_where_they_meet({0x1p16, {{0, 0}, {4, 0}, {1, 0}, {1, 5}}, {{0, 1, 0}, {2, 3, 1}}});
  EXPECT_EQ(touched.edges.size(), 3U);
  const EdgeSet overlapping =
      cut_where_they_meet({0x1p16, {{0, 0}, {4, 0}, {1, 0}, {6, 0}}, {{0, 1, 0}, {2, 3, 1}}});
  EXPECT_EQ(overlapping.edges.size(), 4U);  // 0-1, 1-4 twice, 4-6
}

TEST(CutEdges, MeetInEndsOnlyAfterwards) {
  std::mt19937 random(5);
  for (const int extent_mm : {6, 40, 3000, 100'000, 2'000'000'000}) {
    for (int round = 0; round < 30; ++round) {
      const EdgeSet set = random_edges(random, extent_mm, 40);
      EXPECT_TRUE(meet_in_ends_only(cut_where_they_meet(set))) << extent_mm << ", " << round;
    }
  }
}

TEST(CutEdges, OfBundlesOfNearlyParallelLinesEndsToo) {
  std::mt19937 random(6);
  std::uniform_int_distribution<int> aside(-2, 2);
  for (int round = 0; round < 40; ++round) {
    EdgeSet set;
    PointNumbers numbers(set.points_mm, 2);
    for (int i = 0; i < 25; ++i) {
      set.edges.push_back({numbers.number_of(Point2(aside(random), aside(random))),
                           numbers.number_of(Point2(90'000 + aside(random), 37 + aside(random))),
                           i});
    }
    EXPECT_TRUE(meet_in_ends_only(cut_where_they_meet(set))) << round;
  }
}

TEST(CutEdges, SnapRoundingOfCgalIsAFallbackThatKeepsThePromiseToo) {
  std::mt19937 random(7);
  for (int round = 0; round < 5; ++round) {
    const EdgeSet set = random_edges(random, 3000, 12);
    const EdgeSet snapped = cut_by_snap_rounding(set);
    EXPECT_TRUE(meet_in_ends_only(snapped)) << round;
    EXPECT_NEAR(static_cast<double>(snapped.edges.size()),
                static_cast<double>(cut_where_they_meet(set).edges.size()), 2.0);
  }
}

TEST(Orientation, IsExactWhereRoundedNumbersAreNot) {
  // On the line from the origin to (2^34 + 1, 2^34), or off it by the least the grid has.
  const Point2 end(0x1p34 + 1.0, 0x1p34);
  const Point2 beyond(2.0 * end);
  const Point2 above(beyond.x(), beyond.y() + 0x1p-16);
  EXPECT_EQ(orientation(Point2(0, 0), end, beyond), 0);
  EXPECT_EQ(orientation(Point2(0, 0), end, above), 1);
  EXPECT_EQ(orientation(Point2(0, 0), above, end), -1);
}

}  // namespace
}  // namespace roomatlas::planar
