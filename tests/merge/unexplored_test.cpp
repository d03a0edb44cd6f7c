// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/merge/unexplored.hpp"

#include <gmock/gmock.h>

namespace roomatlas {
namespace {

/// A room of 6 m x 4 m, seen but for the right wall from y = 1 to y = 3:
///     +--------+
///     |        |
///              :
///     |        :
///     +--------+
FloorPlan room() {
  FloorPlan plan;
  plan.free_space = {{{{0, 0}, {6, 0}, {6, 4}, {0, 4}}, {}}};
  return plan;
}

std::vector<Polyline> walls_but_for_the_gap() {
  return {{{6, 0.7}, {6, 0}, {0, 0}, {0, 4}, {6, 4}, {6, 3.3}}};
}

TEST(UnexploredBoundary, IsWhereFreeSpaceEndsAndNoWallWasSeen) {
  const auto lines = unexplored_boundary(room(), walls_but_for_the_gap());
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].size(), 2U);
  EXPECT_NEAR(lines[0].front().y(), 1.0, 0.1);
  EXPECT_NEAR(lines[0].back().y(), 3.0, 0.1);
  EXPECT_DOUBLE_EQ(lines[0].front().x(), 6.0);
}

TEST(UnexploredBoundary, HasFreeSpaceToItsLeft) {
  const auto lines = unexplored_boundary(room(), walls_but_for_the_gap());
  ASSERT_FALSE(lines.empty());
  const Point2 along = lines[0].back() - lines[0].front();
  EXPECT_GT(cross(along, Point2(3, 2) - lines[0].front()), 0.0);
}

TEST(UnexploredBoundary, IsNothingWhereAllWallsWereSeen) {
  EXPECT_TRUE(
      unexplored_boundary(room(), {{{6.1, 0}, {0, -0.1}, {0, 4}, {6, 4.2}, {6.1, 0}}}).empty());
}

TEST(UnexploredBoundary, IsNotADoor) {
  FloorPlan plan = room();
  PlanDoor door;
  door.jambs = {{6, 0.8}, {6, 3.2}};
  plan.doors = {door};
  EXPECT_TRUE(unexplored_boundary(plan, walls_but_for_the_gap()).empty());
}

TEST(UnexploredBoundary, IsNotAWallWithFreeSpaceCloseBehindIt) {
  FloorPlan plan = room();
  plan.free_space.push_back({{{6.2, 0}, {9, 0}, {9, 4}, {6.2, 4}}, {}});
  std::vector<Polyline> walls = walls_but_for_the_gap();
  walls.push_back({{6.2, 0}, {9, 0}, {9, 4}, {6.2, 4}});
  EXPECT_TRUE(unexplored_boundary(plan, walls).empty());
}

TEST(UnexploredBoundary, OfAHoleIsFoundToo) {
  FloorPlan plan = room();
  plan.free_space[0].holes = {{{2, 1}, {2, 3}, {4, 3}, {4, 1}}};
  const auto lines = unexplored_boundary(plan, {{{0, 0}, {6, 0}, {6, 4}, {0, 4}, {0, 0}}});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(length(lines[0]), 8.0, 1e-9);
}

TEST(UnexploredBoundary, DoesNotDependOnWhereARingBegins) {
  FloorPlan turned = room();
  auto& ring = turned.free_space[0].outer;
  std::rotate(ring.begin(), ring.begin() + 2, ring.end());
  const auto a = unexplored_boundary(room(), walls_but_for_the_gap());
  const auto b = unexplored_boundary(turned, walls_but_for_the_gap());
  ASSERT_EQ(a.size(), b.size());
  EXPECT_NEAR(length(a[0]), length(b[0]), 1e-9);
}

TEST(UnexploredBoundary, OfAnEmptyPlanIsEmpty) { EXPECT_TRUE(unexplored_boundary({}, {}).empty()); }

}  // namespace
}  // namespace roomatlas
