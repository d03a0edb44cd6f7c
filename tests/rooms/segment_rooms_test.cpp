// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/rooms/segment_rooms.hpp"

#include <gtest/gtest.h>

#include <set>

#include "rooms/sketched_building.hpp"

namespace roomatlas {
namespace {

using test::SketchedBuilding;

RoomSegmentation rooms_of(const SketchedBuilding& building, const SegmentOptions& options = {}) {
  return segment_rooms(building.grid(), building.path(), options);
}

RoomId room_at(const RoomSegmentation& rooms, double x, double y) {
  return rooms.at(rooms.frame.cell_of({x, y}));
}

TEST(SegmentRooms, ADoorPartsTwoRooms) {
  SketchedBuilding building = test::two_rooms();
  building.drive({{1, 1}, {3, 2.4}, {6, 2.4}, {3, 2.4}, {1, 4}});
  const RoomSegmentation rooms = rooms_of(building);
  ASSERT_EQ(rooms.rooms, 2);
  ASSERT_EQ(rooms.openings.size(), 1U);
  EXPECT_TRUE(rooms.openings[0].is_between_rooms());
  EXPECT_NE(rooms.openings[0].room_b, rooms.openings[0].room_a);
  EXPECT_EQ(rooms.room_of_pose.front(), 1);
  EXPECT_EQ(rooms.room_of_pose.back(), 1) << "back in the first room";
  for (std::size_t i = 0; i < building.path().size(); ++i) {
    const double x = building.path()[i].position().x();
    if (std::abs(x - 4.1) < 0.2) continue;
    EXPECT_EQ(rooms.room_of_pose[i], x < 4.1 ? 1 : 2) << x;
  }
  EXPECT_EQ(room_at(rooms, 2.0, 4.5), 1);
  EXPECT_EQ(room_at(rooms, 6.0, 0.5), 2);
}

TEST(SegmentRooms, WhatWasSeenThroughADoorBelongsToNoRoom) {
  SketchedBuilding building = test::two_rooms();
  building.drive({{1, 1}, {3, 2.4}});
  const RoomSegmentation rooms = rooms_of(building);
  EXPECT_EQ(rooms.rooms, 1);
  ASSERT_EQ(rooms.openings.size(), 1U);
  EXPECT_FALSE(rooms.openings[0].is_between_rooms());
  EXPECT_EQ(room_at(rooms, 6.0, 2.4), 0);
}

TEST(SegmentRooms, ADoorSeenFromBothSidesIsOneThoughItWasNotUsed) {
  SketchedBuilding with_two(8.2, 8.0);
  with_two.box(4.0, 0.0, 4.2, 1.5);
  with_two.box(4.0, 2.4, 4.2, 5.5);
  with_two.box(4.0, 6.4, 4.2, 8.0);
  with_two.drive({{1, 1}, {1, 6.9}, {2, 6.0}, {7, 6.0}, {7, 1}});
  const RoomSegmentation rooms = rooms_of(with_two);
  EXPECT_EQ(rooms.rooms, 2);
  EXPECT_EQ(rooms.openings.size(), 2U);
  for (const Door& opening : rooms.openings) EXPECT_TRUE(opening.is_between_rooms());
}

TEST(SegmentRooms, AGapThatCanBeWalkedAroundIsNoDoor) {
  SketchedBuilding building(9.0, 6.0);
  building.box(4.0, 0.0, 4.2, 2.0);  // a partition with a gap, open at its other end
  building.box(4.0, 2.9, 4.2, 4.2);
  building.drive({{1, 1}, {2, 2.4}, {7, 2.4}, {7, 5.1}, {1, 5.1}});
  const RoomSegmentation rooms = rooms_of(building);
  EXPECT_EQ(rooms.rooms, 1);
  EXPECT_TRUE(rooms.openings.empty());
}

TEST(SegmentRooms, TwoWaysPastAPillarAreInOneRoom) {
  SketchedBuilding building(6.0, 9.0);  // its doors lead to rooms above and below
  building.box(0.0, 2.0, 2.5, 2.2);
  building.box(3.4, 2.0, 6.0, 2.2);
  building.box(0.0, 6.8, 2.5, 7.0);
  building.box(3.4, 6.8, 6.0, 7.0);
  building.box(2.0, 4.0, 4.0, 5.0);
  building.drive({{2.9, 1.0}, {2.9, 2.9}, {2.9, 1.0}});
  building.drive({{2.9, 8.0}, {2.9, 6.1}, {2.9, 8.0}});  // carried there
  const RoomSegmentation rooms = rooms_of(building);
  EXPECT_EQ(rooms.rooms, 3);
  EXPECT_EQ(room_at(rooms, 2.9, 2.9), room_at(rooms, 2.9, 6.1));
}

TEST(SegmentRooms, ARoomTooSmallBelongsToTheNext) {
  SketchedBuilding building(5.4, 5.0);
  building.box(4.0, 0.0, 4.2, 2.0);
  building.box(4.0, 2.9, 4.2, 5.0);
  building.box(4.2, 0.0, 5.4, 1.7);  // leaves 1.2 m x 1.5 m behind the door
  building.box(4.2, 3.2, 5.4, 5.0);
  building.drive({{1, 1}, {3, 2.4}, {4.8, 2.4}});
  EXPECT_EQ(rooms_of(building).rooms, 1);
  SegmentOptions closets;
  closets.min_room_m2 = 0.5;
  EXPECT_EQ(rooms_of(building, closets).rooms, 2);
}

/// Two rooms with a wide door and one of 0.7 m at (4.1, 4.0), in which the robot turns back; it
/// stands too near to a jamb there to see anything with room on both sides.
SketchedBuilding looked_in() {
  SketchedBuilding building(8.2, 5.0);
  building.box(4.0, 0.0, 4.2, 1.0);
  building.box(4.0, 1.9, 4.2, 3.7);
  building.box(4.0, 4.2, 4.2, 5.0);
  building.drive({{1, 1}, {3, 3.95}, {4.18, 3.95}, {3, 3.95}, {3, 1.4}});
  building.drive({{3, 1.4}, {5, 1.4}, {5, 4.6}, {4.7, 4.6}, {4.7, 3.4}});
  return building;
}

TEST(SegmentRooms, ADoorAtWhichTheRobotTurnedBackIsOne) {
  const SketchedBuilding building = looked_in();
  const RoomSegmentation rooms = rooms_of(building);
  EXPECT_EQ(rooms.rooms, 2);
  ASSERT_EQ(rooms.openings.size(), 2U);
  for (const Door& opening : rooms.openings) {
    EXPECT_TRUE(opening.is_between_rooms());
    EXPECT_NE(opening.room_a, opening.room_b);
    EXPECT_TRUE(opening.is_driven);
  }
  SegmentOptions closets;
  closets.min_room_m2 = 0.0;
  EXPECT_EQ(rooms_of(building, closets).rooms, 3) << "it saw the room behind: nothing is tested";
}

/// Two openings beside each other, a post of 0.3 m between them.
SketchedBuilding with_a_post() {
  SketchedBuilding building(8.2, 8.0);
  building.box(4.0, 0.0, 4.2, 3.0);
  building.box(4.0, 3.9, 4.2, 4.2);
  building.box(4.0, 5.1, 4.2, 8.0);
  return building;
}

TEST(SegmentRooms, OfTwoOpeningsAtOneJambTheUnusedIsNone) {
  SketchedBuilding one_used = with_a_post();
  SketchedBuilding both_used = with_a_post();
  one_used.drive({{1, 3.4}, {7, 3.4}});
  both_used.drive({{1, 3.4}, {7, 3.4}, {7, 4.65}, {1, 4.65}});
  SegmentOptions slender;
  slender.doors.min_beside_share = 0.2;  // the post is all there is beside the openings
  const RoomSegmentation once = rooms_of(one_used, slender);
  EXPECT_EQ(once.rooms, 2);
  ASSERT_EQ(once.openings.size(), 1U);
  EXPECT_NEAR(once.openings[0].frame_from_pivot.position().y(), 3.45, 0.1);
  EXPECT_EQ(rooms_of(both_used, slender).openings.size(), 2U);
}

TEST(SegmentRooms, AWindowEndsARoomAndAWidePassageDoesNot) {
  SketchedBuilding building(8.2, 6.0);
  building.box(4.0, 0.0, 4.2, 2.0);
  building.box(4.0, 4.0, 4.2, 6.0);
  SketchedBuilding driven = building;
  building.drive({{1, 1}, {2, 5}});
  EXPECT_EQ(room_at(rooms_of(building), 6.0, 3.0), 0) << "seen through a window";
  driven.drive({{1, 1}, {2, 3}, {7, 3}});
  const RoomSegmentation rooms = rooms_of(driven);
  EXPECT_EQ(rooms.rooms, 1);
  EXPECT_EQ(room_at(rooms, 6.0, 3.0), 1);
}

TEST(SegmentRooms, EveryRoomHasFloor) {
  // two doors in a row, 0.7 m apart: the vestibule between them is no room
  SketchedBuilding building(9.1, 5.0);
  building.box(4.0, 0.0, 5.1, 2.0);
  building.box(4.0, 2.9, 5.1, 5.0);
  building.drive({{1, 1}, {3, 2.4}, {4.55, 2.45}, {7, 2.4}});
  const RoomSegmentation rooms = rooms_of(building);
  EXPECT_EQ(rooms.rooms, 2);
  const auto& cells = rooms.room_of_cell.values;
  std::set<RoomId> with_floor(cells.begin(), cells.end());
  for (RoomId room = 1; room <= rooms.rooms; ++room) EXPECT_TRUE(with_floor.contains(room)) << room;
}

TEST(SegmentRooms, EveryPoseHasARoomAndNumbersFollowTheDrive) {
  SketchedBuilding building = test::two_rooms();
  building.drive({{7, 1}, {5, 2.4}, {1, 2.4}});
  const RoomSegmentation rooms = rooms_of(building);
  EXPECT_EQ(rooms.room_of_pose.size(), building.path().size());
  RoomId most = 0;
  for (const RoomId room : rooms.room_of_pose) {
    EXPECT_GE(room, 1);
    EXPECT_LE(room, most + 1);
    most = std::max(most, room);
  }
  EXPECT_EQ(most, rooms.rooms);
}

}  // namespace
}  // namespace roomatlas
