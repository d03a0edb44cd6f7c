// SPDX-License-Identifier: GPL-3.0-or-later
// An opening that lies aslant is turned into the line of the wall that ends there.
#include "roomatlas/draft/straight_openings.hpp"

#include <gtest/gtest.h>

namespace roomatlas {
namespace {

/// A wall along x = 0 that was seen from y = 0 up, 3 m of it, from both sides.
Walls wall_up() {
  Walls walls;
  for (const double normal_rad : {0.0, -kPi}) {
    WallFace face;
    face.normal_rad = normal_rad;
    face.offset_m = 0.0;
    face.is_regular = true;
    const double to_m = face.along().y() * 3.0;
    face.seen = {{std::min(0.0, to_m), std::max(0.0, to_m)}};
    face.prominence_m = 3.0;
    walls.faces.push_back(face);
  }
  return walls;
}

Door door_between(const Point2& a, const Point2& b) {
  Door door;
  static_cast<Doorway&>(door) = doorway_between(Segment2{a, b});
  door.room_a = 1;
  door.room_b = 2;
  return door;
}

Segment2 straight(const Door& door, const Walls& walls) {
  const Door result = straightened(door, walls, {});
  EXPECT_EQ(result.room_a, door.room_a);
  EXPECT_NEAR(result.width_m, (result.jambs.b - result.jambs.a).norm(), 1e-12);
  return result.jambs;
}

TEST(StraightOpenings, TurnIntoTheLineOfTheWallThatEndsThere) {
  for (const bool is_swapped : {false, true}) {
    const Point2 end(0.05, -0.03);
    const Point2 cupboard(0.9, -2.0);
    const Segment2 line =
        straight(is_swapped ? door_between(cupboard, end) : door_between(end, cupboard), wall_up());
    EXPECT_NEAR(line.a.x(), 0.0, 1e-9);
    EXPECT_NEAR(line.b.x(), 0.0, 1e-9);
    EXPECT_NEAR(std::min(line.a.y(), line.b.y()), -2.0, 1e-9);
    EXPECT_NEAR(std::max(line.a.y(), line.b.y()), -0.03, 1e-9);
  }
}

TEST(StraightOpenings, StayWhereNoWallEnds) {
  const auto expect_same = [](const Door& door, const Walls& walls, const char* why) {
    const Segment2 line = straight(door, walls);
    EXPECT_EQ(line.a, door.jambs.a) << why;
    EXPECT_EQ(line.b, door.jambs.b) << why;
  };
  expect_same(door_between({0.05, -0.03}, {0.04, -0.9}), wall_up(), "straight");
  expect_same(door_between({1.5, -0.03}, {2.3, -1.7}), wall_up(), "not at the wall");
  expect_same(door_between({0.0, -0.03}, {3.0, -1.0}), wall_up(), "square to it");
  expect_same(door_between({0.0, 3.0}, {0.9, 1.2}), wall_up(), "along a wall that does not end");
  Walls slanted = wall_up();
  for (WallFace& face : slanted.faces) face.is_regular = false;
  expect_same(door_between({0.05, -0.03}, {0.9, -2.0}), slanted, "of no direction of the building");
  Walls furniture = wall_up();
  for (WallFace& face : furniture.faces) face.is_furniture = true;
  expect_same(door_between({0.05, -0.03}, {0.9, -2.0}), furniture, "a cupboard's side");
}

}  // namespace
}  // namespace roomatlas
