// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of drawn rooms: what is told of them, by whom, and what is not told.
#include "roomatlas/changes/find_changes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "two_rooms.hpp"

namespace roomatlas {
namespace {

const std::vector<Polyline> kBothRooms = {test::kFirstRoom, test::kSecondRoom};
const Polygon kTable = test::block(7, 6, 3, 2);

PlanChanges compared(const test::KnownMission& before, const test::KnownMission& after) {
  return find_changes(before.mission, after.mission, {});
}

/// Both missions have seen every change, by readings of theirs.
void expect_witnessed(const PlanChanges& found) {
  for (const Change& change : found.changes) {
    for (const Sighting& sighting : {change.before, change.after}) {
      EXPECT_GE(sighting.readings(), 5) << to_string(change.kind);
      EXPECT_FALSE(sighting.visits.empty()) << to_string(change.kind);
      EXPECT_LE(sighting.first_s, sighting.last_s) << to_string(change.kind);
      EXPECT_GE(sighting.first_s, 100.0) << to_string(change.kind);
    }
  }
}

TEST(FindChanges, OfTheSameRoomsNothingIsTold) {
  test::KnownMission before;
  test::KnownMission after;
  const test::WorldDrawing rooms = test::with_block(test::empty_rooms(), 7, 6, 3, 2);
  test::drive(before, rooms, kBothRooms, {kTable});
  test::drive(after, rooms, {test::kSecondRoom, {{1.2, 3.3}, {1.2, 0.9}, {4.2, 0.9}}}, {kTable});
  const PlanChanges found = compared(before, after);
  EXPECT_TRUE(found.changes.empty());
  EXPECT_TRUE(found.rooms.empty());
  EXPECT_GT(found.compared_m2, 25.0);
}

TEST(FindChanges, ATableThatIsGoneAndOneThatIsNewAreEachOthersReverse) {
  test::KnownMission with;
  test::KnownMission without;
  test::drive(with, test::with_block(test::empty_rooms(), 7, 6, 3, 2), kBothRooms, {kTable});
  test::drive(without, test::empty_rooms(), kBothRooms);
  const PlanChanges gone = compared(with, without);
  const PlanChanges appeared = compared(without, with);
  ASSERT_EQ(gone.changes.size(), 1U);
  ASSERT_EQ(appeared.changes.size(), 1U);
  EXPECT_EQ(gone.changes[0].kind, ChangeKind::furniture_gone);
  EXPECT_EQ(appeared.changes[0].kind, ChangeKind::furniture_new);
  EXPECT_EQ(gone.changes[0].room_name, "Office");
  EXPECT_LT((gone.changes[0].at - Point2(2.55, 2.1)).norm(), 0.1);
  EXPECT_NEAR(gone.changes[0].size_m, 0.9, 0.1);
  EXPECT_EQ(gone.changes[0].gone.size(), 1U);
  EXPECT_TRUE(gone.changes[0].appeared.empty());
  expect_witnessed(gone);
  EXPECT_EQ(gone.changes[0].before.stood, appeared.changes[0].after.stood);
  EXPECT_EQ(gone.changes[0].after.passed, appeared.changes[0].before.passed);
  EXPECT_EQ(gone.changes[0].before.passed, 0);
}

TEST(FindChanges, ATableAtAnotherPlaceWasMoved) {
  test::KnownMission before;
  test::KnownMission after;
  test::drive(before, test::with_block(test::empty_rooms(), 7, 6, 3, 2), kBothRooms, {kTable});
  test::drive(after, test::with_block(test::empty_rooms(), 5, 7, 3, 2), kBothRooms,
              {test::block(5, 7, 3, 2)});
  const PlanChanges found = compared(before, after);
  ASSERT_EQ(found.changes.size(), 1U);
  EXPECT_EQ(found.changes[0].kind, ChangeKind::furniture_moved);
  EXPECT_LT((found.changes[0].at - Point2(1.95, 2.4)).norm(), 0.1);
  expect_witnessed(found);
}

TEST(FindChanges, AShutDoorIsTheDoorThatThePlanHas) {
  test::KnownMission open;
  test::KnownMission shut;
  test::drive(open, test::empty_rooms(), kBothRooms);
  test::drive(shut, test::with_block(test::empty_rooms(), 16, 5, 1, 3), kBothRooms);
  const PlanChanges now_shut = compared(open, shut);
  ASSERT_EQ(now_shut.changes.size(), 1U);
  EXPECT_EQ(now_shut.changes[0].kind, ChangeKind::door_shut);
  EXPECT_EQ(now_shut.changes[0].door, 7);
  EXPECT_EQ(now_shut.changes[0].room_name, "Office");
  expect_witnessed(now_shut);
  const PlanChanges now_open = compared(shut, open);
  ASSERT_EQ(now_open.changes.size(), 1U);
  EXPECT_EQ(now_open.changes[0].kind, ChangeKind::door_opened);
}

TEST(FindChanges, AWallThatSticksOutOfAnotherIsAWallThoughThePlanDoesNotSaySo) {
  test::KnownMission before;
  test::KnownMission after;
  test::drive(before, test::empty_rooms(), kBothRooms);
  test::drive(after, test::with_block(test::empty_rooms(), 23, 1, 1, 5),
              {test::kFirstRoom, {{5.7, 0.9}, {5.7, 3.3}, {9.3, 3.3}, {9.3, 0.9}}},
              {test::block(23, 1, 1, 5)});
  const PlanChanges found = compared(before, after);
  ASSERT_EQ(found.changes.size(), 1U);
  EXPECT_EQ(found.changes[0].kind, ChangeKind::wall_new);
  EXPECT_EQ(found.changes[0].room_name, "Lab");
  expect_witnessed(found);
}

TEST(FindChanges, WhatWasNotSeenAgainIsNotGone) {
  test::KnownMission before;
  test::KnownMission after;
  const Polygon corner = test::block(17, 11, 2, 2);  // not to be seen from the first room
  test::drive(before, test::with_block(test::empty_rooms(), 17, 11, 2, 2),
              {test::kFirstRoom, {{5.7, 2.7}, {8.7, 2.7}, {8.7, 0.9}}}, {corner});
  test::drive(after, test::empty_rooms(), {{{0.9, 2.0}, {3.0, 2.0}}});
  const PlanChanges found = compared(before, after);
  EXPECT_TRUE(found.changes.empty());
  ASSERT_EQ(found.rooms.size(), 1U);
  EXPECT_EQ(found.rooms[0].name, "Lab");
  EXPECT_TRUE(found.rooms[0].was_before);
  EXPECT_GT(found.rooms[0].seen_share, 0.1);
  EXPECT_LT(found.rooms[0].seen_share, 0.97);
  double unseen_m2 = 0.0;
  for (const Polygon& piece : found.not_seen_again) unseen_m2 += area(piece);
  EXPECT_NEAR(unseen_m2, (1.0 - found.rooms[0].seen_share) * found.rooms[0].area_m2, 2.5);

  const PlanChanges reverse = compared(after, before);
  EXPECT_TRUE(reverse.changes.empty());
  ASSERT_EQ(reverse.rooms.size(), 1U);
  EXPECT_FALSE(reverse.rooms[0].was_before);
}

TEST(FindChanges, WhoWalkedByIsNoChange) {
  test::KnownMission before;
  test::KnownMission after;
  test::drive(before, test::empty_rooms(), kBothRooms);
  test::drive(after, test::empty_rooms(), kBothRooms);
  // Somebody walks along the first room, 0.5 m a second, while the robot drives.
  Asr& asr = after.store.asrs.front();
  for (std::size_t i = 20; i < 80 && i < asr.readings.size(); ++i) {
    const Point2 at(0.6 + 0.05 * static_cast<double>(i - 20), 2.1);
    RangeReading& reading = asr.readings[i];
    for (std::size_t k = 0; k < reading.ranges_m.size(); ++k) {
      const Pose2 beam = asr.path[i].asr_from_robot * reading.sensor->robot_from_beam[k];
      const Point2 off = inverse(beam) * at;
      const double half_m = std::sqrt(std::max(0.0, 0.04 - off.y() * off.y()));
      if (off.x() > 0.0 && half_m > 0.0) {
        reading.ranges_m[k] = std::min(reading.ranges_m[k], static_cast<float>(off.x() - half_m));
      }
    }
  }
  EXPECT_TRUE(compared(before, after).changes.empty());
}

TEST(FindChanges, ThreadsDoNotMatter) {
  test::KnownMission before;
  test::KnownMission after;
  test::drive(before, test::with_block(test::empty_rooms(), 7, 6, 3, 2), kBothRooms, {kTable});
  test::drive(after, test::empty_rooms(), kBothRooms);
  const PlanChanges one = find_changes(before.mission, after.mission, {}, {}, 1);
  const PlanChanges three = find_changes(before.mission, after.mission, {}, {}, 3);
  ASSERT_EQ(one.changes.size(), three.changes.size());
  for (std::size_t i = 0; i < one.changes.size(); ++i) {
    EXPECT_EQ(one.changes[i].at, three.changes[i].at);
    EXPECT_EQ(one.changes[i].before.stood, three.changes[i].before.stood);
    EXPECT_EQ(one.changes[i].after.visits, three.changes[i].after.visits);
  }
}

TEST(FindChanges, SonarsTellRoomsAlone) {
  test::KnownMission before;
  test::KnownMission after;
  test::drive(before, test::with_block(test::empty_rooms(), 7, 6, 3, 2), kBothRooms, {kTable});
  test::drive(after, test::empty_rooms(), {test::kFirstRoom});
  for (Asr& asr : after.store.asrs) {
    auto sonars = std::make_shared<RangeSensor>(*asr.readings.front().sensor);
    sonars->kind = SensorKind::sonar;
    for (RangeReading& reading : asr.readings) reading.sensor = sonars;
  }
  const PlanChanges found = compared(before, after);
  EXPECT_FALSE(found.tells_changes);
  EXPECT_TRUE(found.changes.empty());
  EXPECT_EQ(found.rooms.size(), 1U);
}

}  // namespace
}  // namespace roomatlas
