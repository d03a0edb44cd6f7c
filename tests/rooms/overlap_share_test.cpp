// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "roomatlas/graph/recognise.hpp"
#include "roomatlas/rooms/assign_rooms.hpp"
#include "support/chain_mission.hpp"

namespace roomatlas {
namespace {

using test::rectangle;

Ring rectangle_of(const Box2& box) {
  return rectangle(box.min.x(), box.min.y(), box.max.x(), box.max.y());
}

double area_of(const Box2& box) { return box.empty() ? 0.0 : box.size().prod(); }

TEST(OverlapShare, OfRectanglesIsTheirCommonAreaOverTheSmaller) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> corner(-3.0, 3.0);
  std::uniform_real_distribution<double> side(3.0, 9.0);
  const auto any_box = [&] {
    const Point2 min(corner(random), corner(random));
    return Box2{min, min + Point2(side(random), side(random))};
  };
  double sum = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Box2 one = any_box();
    const Box2 other = any_box();
    const Box2 common{one.min.cwiseMax(other.min), one.max.cwiseMin(other.max)};
    const double expected = area_of(common) / std::min(area_of(one), area_of(other));
    const double found = overlap_share({rectangle_of(one), {}}, {rectangle_of(other), {}});
    // half a step of the lattice, 0.1 m, on each side of at least 3 m
    EXPECT_NEAR(found, expected, 0.07);
    EXPECT_EQ(found, overlap_share({rectangle_of(other), {}}, {rectangle_of(one), {}}));
    sum += found - expected;
  }
  EXPECT_NEAR(sum / 200.0, 0.0, 0.01) << "on average neither more nor less";
}

TEST(OverlapShare, IsOneForAPolygonWithinTheOtherAndNoneForNeighbors) {
  const Polygon hall{rectangle(0, 0, 20, 10), {}};
  EXPECT_DOUBLE_EQ(overlap_share(hall, hall), 1.0);
  EXPECT_DOUBLE_EQ(overlap_share(hall, {rectangle(2, 2, 5, 5), {}}), 1.0);
  EXPECT_DOUBLE_EQ(overlap_share(hall, {rectangle(20, 0, 25, 10), {}}), 0.0);
  EXPECT_DOUBLE_EQ(overlap_share(hall, {rectangle(30, 0, 35, 10), {}}), 0.0);
}

TEST(OverlapShare, DoesNotCountHoles) {
  const Polygon round_a_block{rectangle(0, 0, 10, 10), {rectangle(2, 2, 8, 8)}};
  EXPECT_DOUBLE_EQ(overlap_share(round_a_block, {rectangle(3, 3, 7, 7), {}}), 0.0);
  EXPECT_NEAR(overlap_share(round_a_block, {rectangle(0, 4, 4, 8), {}}), 0.5, 0.03);
}

TEST(OverlapShare, IsNoneWhereEitherIsEmpty) {
  const Polygon room{rectangle(0, 0, 4, 4), {}};
  EXPECT_EQ(overlap_share({}, room), 0.0);
  EXPECT_EQ(overlap_share(room, {}), 0.0);
  EXPECT_EQ(overlap_share({}, {}), 0.0);
}

}  // namespace
}  // namespace roomatlas
