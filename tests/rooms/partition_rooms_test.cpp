// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/rooms/partition_rooms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "rooms/sketched_map.hpp"

namespace roomatlas {
namespace {

using test::corridor_map;
using test::room_at;
using test::SketchedMap;
using test::two_room_map;

TEST(PartitionRooms, ADoorPartsTwoRooms) {
  const PartitionEvidence map = two_room_map().evidence();
  const RoomPartition rooms = partition_rooms(map);
  EXPECT_EQ(rooms.rooms, 2);
  EXPECT_EQ(rooms.entered_rooms, 0);
  EXPECT_EQ(room_at(rooms, map, {1, 1}), 1) << "the lowest, leftmost is the first";
  EXPECT_EQ(room_at(rooms, map, {7, 4}), 2);
  ASSERT_EQ(rooms.openings.size(), 1U);
  const Opening& door = rooms.openings.front();
  EXPECT_NEAR(door.width_m, 0.9, 0.1);
  EXPECT_NEAR(door.frame_from_pivot.position().y(), 2.45, 0.1);
  EXPECT_NEAR(door.frame_from_pivot.position().x(), 4.1, 0.2);
  EXPECT_NEAR(std::abs(door.jambs.a.y() - door.jambs.b.y()), 0.9, 0.1);
  EXPECT_GT(door.probability, 0.8);
  EXPECT_FALSE(door.is_driven);
}

TEST(PartitionRooms, AnOpeningsWayLeadsFromItsFirstRoomToItsSecond) {
  for (const double turned_rad : {0.0, 0.7, 1.6, 3.0, -1.2}) {
    const PartitionEvidence map = two_room_map().evidence(0.05, turned_rad);
    const RoomPartition rooms = partition_rooms(map);
    ASSERT_EQ(rooms.openings.size(), 1U) << turned_rad;
    const Opening& door = rooms.openings.front();
    const Point2 ahead = direction(door.frame_from_pivot.theta_rad);
    const auto beside = [&](double off_m) {
      return rooms.room_of_cell.get(
          map.frame.cell_of(door.frame_from_pivot.position() + off_m * ahead));
    };
    EXPECT_EQ(beside(0.6), door.room_b);
    EXPECT_EQ(beside(-0.6), door.room_a);
    EXPECT_GT(cross(ahead, door.jambs.a - door.jambs.b), 0.0) << "jamb a is left of the way";
  }
}

/// 13 rooms, and the corridor is one of them, from end to end.
void expect_corridor(const PartitionEvidence& map, double turned_rad) {
  const RoomPartition rooms = partition_rooms(map);
  EXPECT_EQ(rooms.rooms, 13);
  EXPECT_EQ(rooms.openings.size(), 12U);
  const RoomId corridor = room_at(rooms, map, {12, 0}, turned_rad);
  for (double x = 0.5; x < 24.0; x += 0.5) {
    EXPECT_EQ(room_at(rooms, map, {x, 0}, turned_rad), corridor) << x;
  }
  std::set<RoomId> others;
  for (int i = 0; i < 6; ++i) {
    for (const double y : {-3.5, 3.5}) {
      const RoomId room = room_at(rooms, map, {4.0 * i + 2.0, y}, turned_rad);
      EXPECT_EQ(room_at(rooms, map, {4.0 * i + 0.4, 1.5 * y}, turned_rad), room);
      others.insert(room);
    }
  }
  EXPECT_EQ(others.size(), 12U);
  EXPECT_FALSE(others.contains(corridor));
}

TEST(PartitionRooms, ACorridorWithDoorsInLineOnBothSidesIsOneRoom) {
  expect_corridor(corridor_map().evidence(), 0.0);
}

TEST(PartitionRooms, TurningTheMapChangesNothing) {
  for (const double angle_deg : {17.0, 45.0, 100.0}) {
    SCOPED_TRACE(angle_deg);
    expect_corridor(corridor_map().evidence(0.05, radians(angle_deg)), radians(angle_deg));
  }
}

TEST(PartitionRooms, CellsOfTwiceTheSizeChangeNothing) {
  expect_corridor(corridor_map().evidence(0.1), 0.0);
  expect_corridor(corridor_map().evidence(0.1, radians(30)), radians(30));
}

TEST(PartitionRooms, FurnitureThatStandsFreeIsPartOfItsRoom) {
  SketchedMap sketch = SketchedMap().floor(0, 0, 8, 6);
  sketch.obstacle(2, 2, 3, 2.8).obstacle(4, 3, 5, 4).obstacle(5.5, 1, 5.6, 1.1);
  const PartitionEvidence map = sketch.evidence();
  const RoomPartition rooms = partition_rooms(map);
  EXPECT_EQ(rooms.rooms, 1);
  EXPECT_TRUE(rooms.openings.empty());
  EXPECT_EQ(room_at(rooms, map, {2.5, 2.4}), 1);
  EXPECT_EQ(room_at(rooms, map, {4.5, 3.5}), 1);
}

TEST(PartitionRooms, WhatIsTooSmallBelongsToTheNextRoom) {
  SketchedMap sketch = SketchedMap().floor(0, 0, 5, 5).floor(5.2, 2, 6.4, 3.2);
  sketch.floor(4.9, 2.2, 5.3, 3.0);
  const PartitionEvidence map = sketch.evidence();
  EXPECT_EQ(partition_rooms(map).rooms, 1);
  PartitionOptions closets;
  closets.min_room_m2 = 1.0;
  EXPECT_EQ(partition_rooms(map, closets).rooms, 2);
}

TEST(PartitionRooms, ALowerLimitOfProbabilityLeavesMoreRooms) {
  const PartitionEvidence map = two_room_map().evidence();
  PartitionOptions all;
  all.min_door_probability = 1.1;
  EXPECT_EQ(partition_rooms(map, all).rooms, 1);
  EXPECT_EQ(partition_rooms(map).rooms, 2);
}

TEST(PartitionRooms, WithoutFloorThereAreNoRooms) {
  EXPECT_EQ(partition_rooms({}).rooms, 0);
  PartitionEvidence walls = SketchedMap().obstacle(0, 0, 2, 2).evidence();
  EXPECT_EQ(partition_rooms(walls).rooms, 0);
  walls.building_from_robot = {{100.0, 100.0, 0.0}};
  const RoomPartition rooms = partition_rooms(walls);
  EXPECT_EQ(rooms.rooms, 0);
  EXPECT_EQ(rooms.room_of_pose, std::vector<RoomId>{0});
  EXPECT_EQ(rooms.room_of_cell.values.size(), walls.free.domain.count());
}

TEST(PartitionRooms, MasksMustShareOneBox) {
  PartitionEvidence map = two_room_map().evidence();
  map.obstacle = CellMask({{0, 0}, {1, 1}});
  EXPECT_THROW((void)partition_rooms(map), std::invalid_argument);
  map = two_room_map().evidence();
  map.frame.cell_m = 0.0;
  EXPECT_THROW((void)partition_rooms(map), std::invalid_argument);
}

TEST(PartitionRooms, RoomsAreNumberedAsThePathEntersThem) {
  SketchedMap sketch = corridor_map();
  sketch.drive({{14.0, 4.0}, {12.9, 2.0}, {12.9, 0.0}, {0.9, 0.0}, {0.9, 3.0}});
  const PartitionEvidence map = sketch.evidence();
  const RoomPartition rooms = partition_rooms(map);
  EXPECT_EQ(rooms.rooms, 13);
  EXPECT_EQ(rooms.entered_rooms, 3);
  EXPECT_EQ(room_at(rooms, map, {14, 4}), 1);
  EXPECT_EQ(room_at(rooms, map, {6, 0}), 2);
  EXPECT_EQ(room_at(rooms, map, {2, 3}), 3);
  ASSERT_EQ(rooms.room_of_pose.size(), map.building_from_robot.size());
  RoomId most = 0;
  for (const RoomId room : rooms.room_of_pose) {
    EXPECT_GE(room, 1);
    EXPECT_LE(room, most + 1);
    most = std::max(most, room);
  }
  EXPECT_EQ(std::count_if(rooms.openings.begin(), rooms.openings.end(),
                          [](const Opening& opening) { return opening.is_driven; }),
            2);
}

TEST(PartitionRooms, AGlimpseThroughADoorIsNoRoom) {
  // behind the door a fan of floor that nothing but the reach of the beams ends
  SketchedMap sketch = SketchedMap().floor(0, 0, 4, 5);
  sketch.unseen(4.2, -2, 9, 7).floor(4.2, 1.6, 8.0, 3.3).floor(3.9, 2, 4.3, 2.9);
  const PartitionEvidence finished = sketch.evidence();
  sketch.drive({{1, 1}, {3, 2.4}});
  const PartitionEvidence map = sketch.evidence();
  const RoomPartition rooms = partition_rooms(map);
  EXPECT_EQ(rooms.rooms, 1);
  EXPECT_EQ(room_at(rooms, map, {7, 2.4}), 0);
  EXPECT_EQ(partition_rooms(finished).rooms, 2) << "on a finished map it is one";
}

TEST(PartitionRooms, ARoomThatWasSeenAndNotEnteredIsOneWhenItsWallsWereSeen) {
  SketchedMap sketch = two_room_map();
  sketch.drive({{1, 1}, {3, 2.4}});
  const PartitionEvidence map = sketch.evidence();
  const RoomPartition rooms = partition_rooms(map);
  EXPECT_EQ(rooms.rooms, 2);
  EXPECT_EQ(rooms.entered_rooms, 1);
  EXPECT_EQ(room_at(rooms, map, {7, 2.4}), 2);
}

TEST(PartitionRooms, AMissionsSpeckleAndSingleBeamsAreNoFloor) {
  SketchedMap sketch = two_room_map();
  sketch.obstacle(1.0, 3.0, 1.1, 3.1).floor(-3.0, 1.0, 0.1, 1.1);  // a speck, a beam through glass
  sketch.drive({{1, 1}, {3, 2.4}, {7, 2.4}});
  const PartitionEvidence map = sketch.evidence();
  const RoomPartition rooms = partition_rooms(map);
  EXPECT_EQ(rooms.rooms, 2);
  EXPECT_EQ(room_at(rooms, map, {1.05, 3.05}), 1);
  EXPECT_EQ(room_at(rooms, map, {-2, 1.05}), 0);
}

TEST(PartitionRooms, WideOpeningsThatAreDrivenThroughArePartsOfAHall) {
  SketchedMap hall = SketchedMap().floor(0, 0, 16, 12);
  for (const double x : {3.8, 7.8, 11.8}) {
    for (const double y : {3.8, 7.8}) hall.obstacle(x, y, x + 1.4, y + 0.4);
  }
  hall.drive({{1, 2}, {15, 2}, {15, 6}, {1, 6}, {1, 10}, {15, 10}});
  hall.drive({{15, 10}, {10, 10}, {10, 2}, {6, 2}, {6, 10}, {2, 10}, {2, 2}});
  EXPECT_EQ(partition_rooms(hall.evidence()).rooms, 1);
}

TEST(PartitionRooms, TheSameMapGivesTheSameRooms) {
  const PartitionEvidence map = corridor_map().evidence(0.05, 0.3);
  const RoomPartition first = partition_rooms(map);
  const RoomPartition second = partition_rooms(map);
  EXPECT_EQ(first.room_of_cell.values, second.room_of_cell.values);
  ASSERT_EQ(first.openings.size(), second.openings.size());
  for (std::size_t i = 0; i < first.openings.size(); ++i) {
    EXPECT_EQ(first.openings[i].jambs.a, second.openings[i].jambs.a);
    EXPECT_EQ(first.openings[i].probability, second.openings[i].probability);
  }
}

}  // namespace
}  // namespace roomatlas
