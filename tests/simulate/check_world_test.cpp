// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/issue.hpp"
#include "roomatlas/planar/heal.hpp"
#include "roomatlas/simulate/world.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace roomatlas {
namespace {

Ring rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

PlanRoom room(RoomId id, const std::string& name, const Ring& outline) {
  PlanRoom made;
  made.id = id;
  made.name = name;
  made.parts = {{outline, {}}};
  made.label_point = (bounds(outline).min + bounds(outline).max) / 2.0;
  return made;
}

PlanDoor door(std::int64_t id, std::optional<RoomId> a, std::optional<RoomId> b, double x,
              double y) {
  return {id,
          {{x, y - 0.45}, {x, y + 0.45}},
          0.9,
          rectangle(x - 0.1, y - 0.45, x + 0.1, y + 0.45),
          a,
          b,
          DoorKind::door,
          std::nullopt};
}

/// Three rooms of 4 m x 4 m in a row, in one wall body, doors from each to the next.
FloorPlan three_rooms() {
  FloorPlan world;
  world.rooms = {room(1, "Office", rectangle(0.2, 0.2, 4.2, 4.2)),
                 room(2, "2", rectangle(4.4, 0.2, 8.4, 4.2)),
                 room(3, "Store", rectangle(8.6, 0.2, 12.6, 4.2))};
  world.doors = {door(1, 1, 2, 4.3, 2), door(2, 2, 3, 8.5, 2)};
  const Ring around = {{0.2, 0.2},  {0.2, 4.2},  {4.2, 4.2},  {4.2, 2.45}, {4.4, 2.45},
                       {4.4, 4.2},  {8.4, 4.2},  {8.4, 2.45}, {8.6, 2.45}, {8.6, 4.2},
                       {12.6, 4.2}, {12.6, 0.2}, {8.6, 0.2},  {8.6, 1.55}, {8.4, 1.55},
                       {8.4, 0.2},  {4.4, 0.2},  {4.4, 1.55}, {4.2, 1.55}, {4.2, 0.2}};
  world.walls = {{rectangle(0, 0, 12.8, 4.4), {around}}};
  return world;
}

std::string text_of(const Issues& issues) {
  std::string text;
  for (const Issue& issue : issues) text += to_string(issue) + "\n";
  return text;
}

template <typename Action>
std::string input_error(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(CheckWorld, FindsNothingWrongWithASoundWorld) {
  EXPECT_EQ(text_of(check_world(three_rooms())), "");
  EXPECT_NO_THROW(require_sound(three_rooms()));
}

/// 300 rooms on one place have 44,850 pairs: the first are said, and that there are more.
TEST(CheckWorld, OfAHeapOfRoomsNamesTheFirstThatOverlap) {
  FloorPlan world = three_rooms();
  world.rooms.clear();
  for (RoomId id = 1; id <= 300; ++id) {
    world.rooms.push_back(room(id, "", rectangle(0.01 * static_cast<double>(id), 0.0, 9.0, 4.0)));
  }
  Issues issues = check_world(world);
  std::erase_if(issues, [](const Issue& issue) { return issue.severity != Severity::error; });
  ASSERT_EQ(issues.size(), 101U);
  EXPECT_EQ(issues.front().field, "room 1");
  EXPECT_THAT(to_string(issues.back()), testing::HasSubstr("lie on one another all over"));
}

TEST(CheckWorld, RefusesAnOutlineOfManyCrossings) {
  FloorPlan world = three_rooms();
  Ring star;  // each chord crosses nearly all others
  for (int i = 0; i < 1001; ++i) star.push_back(2.0 * direction(2.0 * kPi * 500 * i / 1001.0));
  Ring round;
  for (int i = 0; i < 1001; ++i) round.push_back(2.0 * direction(2.0 * kPi * i / 1001.0));
  for (const bool is_star : {true, false}) {
    world.rooms.push_back(room(4, "Hall", is_star ? star : round));
    for (Point2& corner : world.rooms.back().parts[0].outer) corner += Point2(50.0, 50.0);
    const std::string text = text_of(check_world(world));
    EXPECT_EQ(text.find("crosses itself") != std::string::npos, is_star) << text;
    world.rooms.pop_back();
  }
}

/// As rooms of a labelled map do whose cells meet at corners.
TEST(CheckWorld, TakesAnOutlineThatTouchesItself) {
  FloorPlan world = three_rooms();
  constexpr int kSteps = 120;
  Ring stair;  // up along corners, and back down through every other one of them
  for (int i = 0; i < kSteps; ++i) {
    stair.emplace_back(50.0 + 0.1 * i, 50.0 + 0.1 * i);
    stair.emplace_back(50.0 + 0.1 * (i + 1), 50.0 + 0.1 * i);
  }
  stair.emplace_back(50.0 + 0.1 * kSteps, 50.0 + 0.1 * kSteps);
  for (int i = kSteps - 2; i > 0; i -= 2) {
    stair.emplace_back(50.0 + 0.1 * i, 50.0 + 0.1 * (i + 1));
    stair.emplace_back(50.0 + 0.1 * i, 50.0 + 0.1 * i);
  }
  ASSERT_FALSE(planar::is_simple({stair, {}}));
  world.rooms.push_back(room(4, "Hall", stair));
  EXPECT_EQ(text_of(check_world(world)).find("crosses itself"), std::string::npos);
}

TEST(CheckWorld, NamesRoomsThatOverlapAndTheirCommonArea) {
  FloorPlan world = three_rooms();
  world.rooms[1].parts = {{rectangle(3.7, 1.2, 8.4, 4.2), {}}};  // 0.5 m x 3 m in the office
  const Issues issues = check_world(world);
  ASSERT_EQ(issues.size(), 1U) << text_of(issues);
  EXPECT_EQ(issues[0].severity, Severity::error);
  EXPECT_EQ(to_string(issues[0]),
            "room 1 \"Office\": overlaps room 2 on 1.50 m2: move or cut one of the two outlines");
  EXPECT_EQ(input_error([&] { require_sound(world); }), to_string(issues[0]));
}

TEST(CheckWorld, RoomsThatShareAWallLineOrAMillimetreDoNotOverlap) {
  FloorPlan world = three_rooms();
  world.rooms[1].parts = {{rectangle(4.199, 0.2, 8.6, 4.2), {}}};
  EXPECT_EQ(text_of(check_world(world)), "");
}

TEST(CheckWorld, ARoomWithoutADoorIsClosedOff) {
  FloorPlan world = three_rooms();
  world.doors.pop_back();
  const Issues issues = check_world(world);
  ASSERT_EQ(issues.size(), 1U) << text_of(issues);
  EXPECT_EQ(issues[0].severity, Severity::warning);
  EXPECT_EQ(issues[0].field, "room 3 \"Store\"");
  EXPECT_EQ(issues[0].message.substr(0, 10), "closed off");
  EXPECT_NO_THROW(require_sound(world));
}

TEST(CheckWorld, RoomsThatAreJoinedToEachOtherOnlyAreClosedOffTogether) {
  FloorPlan world = three_rooms();
  world.rooms.push_back(room(4, "4", rectangle(20, 0, 24, 4)));
  world.rooms.push_back(room(5, "5", rectangle(24.2, 0, 28, 4)));
  world.doors.push_back(door(3, 4, 5, 24.1, 2));
  const Issues issues = check_world(world);
  ASSERT_EQ(issues.size(), 1U) << text_of(issues);
  EXPECT_EQ(issues[0].field, "room 4, room 5");
}

TEST(CheckWorld, ADoorThatNamesNoRoomIsReported) {
  FloorPlan world = three_rooms();
  world.doors.push_back(door(7, {}, {}, 4.3, 3.5));
  const Issues issues = check_world(world);
  ASSERT_EQ(issues.size(), 1U) << text_of(issues);
  EXPECT_EQ(issues[0].severity, Severity::warning);
  EXPECT_EQ(issues[0].field, "door 7");
}

TEST(CheckWorld, AWorldWithoutDoorsGetsANoteOnly) {
  FloorPlan world = three_rooms();
  world.doors.clear();
  const Issues issues = check_world(world);
  ASSERT_EQ(issues.size(), 1U) << text_of(issues);
  EXPECT_EQ(issues[0].severity, Severity::note);
  EXPECT_EQ(issues[0].field, "doors");
}

TEST(CheckWorld, AnEmptyPlanIsAnErrorBecauseNothingWouldStopARobot) {
  const Issues issues = check_world({});
  ASSERT_EQ(issues.size(), 3U) << text_of(issues);
  EXPECT_EQ(issues[0].severity, Severity::error);
  EXPECT_EQ(issues[0].field, "walls");
  EXPECT_NE(input_error([] { require_sound({}); }).find("\"wall\""), std::string::npos);
}

TEST(RequireFree, ARobotInTheMiddleOfARoomOrInADoorStandsFree) {
  EXPECT_NO_THROW(require_free(three_rooms(), {2.2, 2.2}, 0.3));
  EXPECT_NO_THROW(require_free(three_rooms(), {4.3, 2.0}, 0.3));
}

TEST(RequireFree, ARobotInAWallIsToldTheWallAndAFreePlace) {
  EXPECT_EQ(input_error([] {
              require_free(three_rooms(), {4.3, 3.5}, 0.3);
            }),
            "the robot's place (4.30, 3.50) is in wall 1: choose a free place, such as "
            "(2.20, 2.20) in room 1");
}

TEST(RequireFree, ARobotTooNearToFurnitureIsToldHowNear) {
  FloorPlan world = three_rooms();
  world.furniture = {
      {{rectangle(2, 1, 3, 3), {}}, FurnitureKind::free_standing}};  // on the middle of room 1
  EXPECT_EQ(input_error([&] {
              require_free(world, {3.2, 2.5}, 0.3);
            }),
            "the robot's place (3.20, 2.50) is 0.20 m from piece of furniture 1 at (3.00, 2.50), "
            "and the robot needs 0.30 m: choose a free place, such as (6.40, 2.20) in room 2");
}

TEST(RequireFree, ARobotOutsideTheBuildingIsRefused) {
  const std::string message = input_error([] { require_free(three_rooms(), {20, 2}, 0.3); });
  EXPECT_NE(message.find("outside of all rooms"), std::string::npos) << message;
}

TEST(RequireFree, WithoutRoomsAnyPlaceClearOfWallsWillDo) {
  FloorPlan world = three_rooms();
  world.rooms.clear();
  EXPECT_NO_THROW(require_free(world, {2.2, 2.2}, 0.3));
  EXPECT_NE(input_error([&] {
              require_free(world, {0.1, 0.1}, 0.3);
            }).find("more room around"),
            std::string::npos);
}

TEST(RequireFree, APlaceThatIsNoNumberIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(input_error([&] {
              require_free(three_rooms(), {nan, 1}, 0.3);
            }).find("finite"),
            std::string::npos);
}

}  // namespace
}  // namespace roomatlas
