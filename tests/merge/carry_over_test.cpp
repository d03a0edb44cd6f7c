// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/merge/carry_over.hpp"

#include <gmock/gmock.h>

namespace roomatlas {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

PlanRoom room(RoomId id, const std::string& name, double x0, double x1) {
  PlanRoom room;
  room.id = id;
  room.name = name;
  room.parts = {{{{x0, 0}, {x1, 0}, {x1, 3}, {x0, 3}}, {}}};
  room.area_m2 = 3.0 * (x1 - x0);
  return room;
}

PlanDoor door(RoomId a, RoomId b) {
  PlanDoor door;
  door.id = 1;
  door.room_a = a;
  door.room_b = b;
  return door;
}

TEST(CarryOver, GivesNumbersAndNamesToTheRoomsThatOverlapMost) {
  const std::vector<PlanRoom> former = {room(1, "1", 0, 4), room(5, "Lab 315", 4, 8)};
  FloorPlan plan;
  plan.rooms = {room(1, "1", 4.2, 8.1), room(2, "2", 0.1, 4.1)};
  plan.doors = {door(1, 2)};
  plan.edges = {{1, {{4.2, 0}, {8.1, 0}}, WallEvidence::measured, std::nullopt},
                {2, {{0.1, 0}, {4.1, 0}}, WallEvidence::measured, std::nullopt}};
  std::map<AsrId, RoomId> room_of_asr = {{10, 1}, {11, 2}};
  EXPECT_THAT(carry_over(former, plan, room_of_asr).lost, IsEmpty());
  ASSERT_EQ(plan.rooms.size(), 2U);
  EXPECT_EQ(plan.rooms[0].id, 1);
  EXPECT_EQ(plan.rooms[0].name, "1");
  EXPECT_EQ(plan.rooms[1].id, 5);
  EXPECT_EQ(plan.rooms[1].name, "Lab 315");
  EXPECT_EQ(plan.doors[0].room_a, 1);
  EXPECT_EQ(plan.doors[0].room_b, 5);
  ASSERT_EQ(plan.edges.size(), 2U);
  EXPECT_EQ(plan.edges[0].room, 1);
  EXPECT_DOUBLE_EQ(plan.edges[0].line.a.x(), 0.1);
  EXPECT_EQ(plan.edges[1].room, 5);
  EXPECT_EQ(room_of_asr, (std::map<AsrId, RoomId>{{10, 5}, {11, 1}}));
}

TEST(CarryOver, NamesANamedRoomThatIsNotFoundAgain) {
  const std::vector<PlanRoom> former = {room(1, "Kitchen", 50, 54), room(2, "2", 60, 64)};
  FloorPlan plan;
  plan.rooms = {room(1, "1", 0, 4)};
  std::map<AsrId, RoomId> room_of_asr;
  const CarriedOver carried = carry_over(former, plan, room_of_asr);
  const Issues& lost = carried.lost;
  ASSERT_EQ(lost.size(), 1U);
  ASSERT_EQ(carried.absent.size(), 1U);
  EXPECT_EQ(carried.absent[0].name, "Kitchen");
  EXPECT_THAT(lost[0].message, HasSubstr("Kitchen"));
  EXPECT_EQ(plan.issues.size(), 1U);
  EXPECT_EQ(plan.rooms[0].id, 3) << "the number of a room that is gone is not given to another";
  EXPECT_EQ(plan.rooms[0].name, "3");
}

TEST(CarryOver, OfARoomThatWasSplitTheLargerPartKeepsTheName) {
  const std::vector<PlanRoom> former = {room(7, "Hall", 0, 10)};
  FloorPlan plan;
  plan.rooms = {room(1, "1", 0, 4), room(2, "2", 4, 10)};
  std::map<AsrId, RoomId> room_of_asr;
  EXPECT_THAT(carry_over(former, plan, room_of_asr).lost, IsEmpty());
  EXPECT_EQ(plan.rooms[0].name, "1");
  EXPECT_EQ(plan.rooms[1].name, "Hall");
  EXPECT_EQ(plan.rooms[1].id, 7);
}

TEST(CarryOver, OfTheSamePlanChangesNothing) {
  const std::vector<PlanRoom> former = {room(1, "1", 0, 4), room(2, "Lab", 4, 8)};
  FloorPlan plan;
  plan.rooms = {room(1, "1", 0, 4), room(2, "2", 4, 8)};
  std::map<AsrId, RoomId> room_of_asr = {{1, 2}};
  EXPECT_THAT(carry_over(former, plan, room_of_asr).lost, IsEmpty());
  EXPECT_EQ(plan.rooms[0].id, 1);
  EXPECT_EQ(plan.rooms[1].name, "Lab");
  EXPECT_EQ(room_of_asr.at(1), 2);
}

TEST(CarryOver, FromNothingChangesNothing) {
  FloorPlan plan;
  plan.rooms = {room(1, "1", 0, 4), room(2, "Atrium", 4, 8)};
  std::map<AsrId, RoomId> room_of_asr;
  EXPECT_THAT(carry_over({}, plan, room_of_asr).lost, IsEmpty());
  EXPECT_EQ(plan.rooms[1].name, "Atrium");
}

}  // namespace
}  // namespace roomatlas
