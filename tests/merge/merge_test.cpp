// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/merge/merge.hpp"
#include "roomatlas/planar/union.hpp"

#include "merge/shapes.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <random>

namespace roomatlas {
namespace {

using test::contains_any;
using test::rectangle;
using test::total_area;

PlacedOutline outline(AsrId asr, RoomId room, Ring ring) { return {asr, room, {ring, {}}}; }

/// Two rooms of 4 m x 3 m, 0.2 m apart, with a door of 0.9 m in the middle:
///     +-----------+ +-----------+
///     |     1      #      2     |
///     +-----------+ +-----------+
std::vector<PlacedOutline> two_rooms() {
  return {outline(1, 1, rectangle(0, 0, 4, 3)), outline(2, 2, rectangle(4.2, 0, 8.2, 3))};
}
const Door kDoor = door_between({{4.1, 1.95}, {4.1, 1.05}}, 2, 1);

bool mentions(const Issues& issues, const std::string& field, const std::string& text) {
  return std::any_of(issues.begin(), issues.end(), [&](const Issue& issue) {
    return issue.field == field && issue.message.find(text) != std::string::npos;
  });
}

TEST(Merge, OfNothingIsAnEmptyPlan) {
  const FloorPlan plan = merge({}, {}, {});
  EXPECT_TRUE(plan.rooms.empty());
  EXPECT_TRUE(plan.doors.empty());
  EXPECT_TRUE(plan.walls.empty());
  EXPECT_TRUE(plan.free_space.empty());
  EXPECT_TRUE(plan.issues.empty());
}

TEST(Merge, GivesARoomItsAreaNameAndLabelPoint) {
  const FloorPlan plan = merge({outline(3, 7, rectangle(0, 0, 4, 3))}, {}, {});
  ASSERT_EQ(plan.rooms.size(), 1U);
  const PlanRoom& room = plan.rooms[0];
  EXPECT_EQ(room.id, 7);
  EXPECT_EQ(room.name, "7");
  EXPECT_DOUBLE_EQ(room.area_m2, 12.0);
  EXPECT_THAT(room.asrs, testing::ElementsAre(3));
  EXPECT_NEAR(distance_to_boundary(room.parts[0].outer, room.label_point), 1.5, 0.05);
}

TEST(Merge, PutsAWallOfTheGivenThicknessWithSharpCornersAroundARoom) {
  const FloorPlan plan =
      merge({outline(1, 1, rectangle(0, 0, 4, 3))}, {}, {.wall_thickness_m = 0.2});
  ASSERT_EQ(plan.walls.size(), 1U);
  EXPECT_THAT(plan.walls[0].outer, testing::ElementsAre(Point2(-0.2, -0.2), Point2(4.2, -0.2),
                                                        Point2(4.2, 3.2), Point2(-0.2, 3.2)));
  EXPECT_THAT(plan.walls[0].holes, testing::SizeIs(1));
  EXPECT_NEAR(total_area(plan.walls), 4.4 * 3.4 - 12.0, 1e-9);
}

TEST(Merge, FillsTheGapBetweenTwoRoomsWithOneWall) {
  const FloorPlan plan = merge(two_rooms(), {}, {});
  ASSERT_EQ(plan.walls.size(), 1U);
  EXPECT_TRUE(contains_any(plan.walls, {4.1, 1.5}));
  EXPECT_EQ(plan.walls[0].holes.size(), 2U);
}

TEST(Merge, LeavesNoCavityInAWallThatIsALittleThickerThanTwoBands) {
  const FloorPlan plan =
      merge({outline(1, 1, rectangle(0, 0, 4, 3)), outline(2, 2, rectangle(4.35, 0, 8, 3)),
             outline(3, 3, rectangle(0, 3.2, 8, 5)), outline(4, 4, rectangle(0, -2, 8, -0.2))},
            {}, {});
  EXPECT_TRUE(contains_any(plan.walls, {4.175, 1.5}));
}

TEST(Merge, ADoorOpensTheWallFromFloorToFloor) {
  const FloorPlan plan = merge(two_rooms(), {kDoor}, {});
  ASSERT_EQ(plan.doors.size(), 1U);
  const PlanDoor& door = plan.doors[0];
  EXPECT_EQ(door.id, 1);
  EXPECT_EQ(door.room_a, 1);
  EXPECT_EQ(door.room_b, 2);
  EXPECT_NEAR(door.width_m, 0.9, 1e-9);
  EXPECT_NEAR(signed_area(door.opening), 0.9 * 0.2, 0.9 * 0.004);
  EXPECT_FALSE(contains_any(plan.walls, {4.1, 1.5}));
  EXPECT_TRUE(contains_any(plan.walls, {4.1, 0.9}));
  EXPECT_LT(overlap_area(plan.walls, {{door.opening, {}}}), 1e-9);
  EXPECT_EQ(plan.free_space.size(), 1U);
  for (const PlanRoom& room : plan.rooms) EXPECT_NEAR(room.area_m2, 12.0, 0.003);
}

TEST(Merge, ADoorIsAsDeepAsTheWallBesideItWhereFloorsRunIntoTheDoorway) {
  const Ring left = {{0, 0},      {4, 0},    {4, 1.05}, {4.1, 1.05},
                     {4.1, 1.95}, {4, 1.95}, {4, 3},    {0, 3}};
  const Ring right = {{4.1, 1.05}, {4.2, 1.05}, {4.2, 0},    {8.2, 0},
                      {8.2, 3},    {4.2, 3},    {4.2, 1.95}, {4.1, 1.95}};
  const FloorPlan plan = merge({outline(1, 1, left), outline(2, 2, right)}, {kDoor}, {});
  EXPECT_NEAR(signed_area(plan.doors[0].opening), 0.9 * 0.2, 0.9 * 0.004);
  EXPECT_NEAR(plan.rooms[0].area_m2, 12.0, 0.003);
}

TEST(Merge, ADoorWithAnUnseenSideIsOneWallThicknessDeep) {
  const Door out = door_between({{0.0, 1.0}, {0.0, 2.0}}, 1, std::nullopt);
  const FloorPlan plan = merge(two_rooms(), {out}, {.wall_thickness_m = 0.2});
  EXPECT_EQ(plan.doors[0].room_a, 1);
  EXPECT_EQ(plan.doors[0].room_b, std::nullopt);
  EXPECT_NEAR(signed_area(plan.doors[0].opening), 0.2, 0.003);
  EXPECT_FALSE(contains_any(plan.walls, {-0.1, 1.5}));
}

TEST(Merge, GivesAnOverlapToTheRoomWithMoreOutlinesThere) {
  const auto big = [](AsrId asr) { return outline(asr, 1, rectangle(0, 0, 6, 4)); };
  const PlacedOutline small = outline(3, 2, rectangle(5, 0, 8, 4));
  const FloorPlan once = merge({big(1), small}, {}, {});
  EXPECT_DOUBLE_EQ(once.rooms[0].area_m2, 20.0);  // a tie: the smaller room has it
  EXPECT_DOUBLE_EQ(once.rooms[1].area_m2, 12.0);
  const FloorPlan twice = merge({big(1), big(2), small}, {}, {});
  EXPECT_DOUBLE_EQ(twice.rooms[0].area_m2, 24.0);
  EXPECT_DOUBLE_EQ(twice.rooms[1].area_m2, 8.0);
}

TEST(Merge, ARoomInTheMiddleOfAnotherIsAHoleInIt) {
  const FloorPlan plan =
      merge({outline(1, 1, rectangle(0, 0, 10, 10)), outline(2, 2, rectangle(4, 4, 6, 6))}, {}, {});
  ASSERT_EQ(plan.rooms.size(), 2U);
  EXPECT_DOUBLE_EQ(plan.rooms[0].area_m2, 96.0);
  EXPECT_EQ(plan.rooms[0].parts.at(0).holes.size(), 1U);
  EXPECT_DOUBLE_EQ(plan.rooms[1].area_m2, 4.0);
  EXPECT_FALSE(contains(plan.rooms[0].parts[0], {5, 5}));
}

TEST(Merge, SmallPiecesCutOffByAnotherRoomGoToIt) {
  const FloorPlan plan =
      merge({outline(1, 1, rectangle(0, 0, 3.1, 1)),  // its end looks through 2
             outline(2, 2, rectangle(2, 0, 3, 1)), outline(3, 2, rectangle(2, 0, 3, 1))},
            {}, {});
  ASSERT_EQ(plan.rooms.size(), 2U);
  EXPECT_EQ(plan.rooms[0].parts.size(), 1U);
  EXPECT_DOUBLE_EQ(plan.rooms[0].area_m2, 2.0);
  EXPECT_DOUBLE_EQ(total_area(plan.free_space), 3.0);
  EXPECT_TRUE(mentions(plan.issues, "room 1", "a piece of 0.100 m2 became unknown"));
}

TEST(Merge, ARoomWithoutAPlaceIsReported) {
  const FloorPlan plan = merge({outline(1, 1, rectangle(0, 0, 3, 1)), outline(2, 2, {})}, {}, {});
  ASSERT_EQ(plan.rooms.size(), 1U);
  EXPECT_TRUE(mentions(plan.issues, "room 2", "no place of its own"));
  EXPECT_TRUE(mentions(plan.issues, "outline of ASR 2", "fewer than three"));
}

TEST(Merge, ReportsWhatItHeals) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const FloorPlan plan =
      merge({outline(1, 1, {{0, 0}, {nan, 0}, {4, 0}, {4, 0}, {4, 3}, {0, 3}}),
             outline(2, 2, {{10, 0}, {14, 4}, {14, 0}, {10, 4}}),
             outline(3, 3, {{20, 3}, {24, 3}, {24, 0}, {20, 0}})},
            {door_between({{0, 0}, {nan, 1}}, 1, 2), door_between({{1, 1}, {1, 1}}, 1, 2)}, {});
  EXPECT_TRUE(mentions(plan.issues, "outline of ASR 1", "1 vertices are not finite"));
  EXPECT_TRUE(mentions(plan.issues, "outline of ASR 1", "1 repeated"));
  EXPECT_TRUE(mentions(plan.issues, "outline of ASR 2", "crosses itself"));
  EXPECT_TRUE(mentions(plan.issues, "outline of ASR 3", "clockwise"));
  EXPECT_EQ(std::count_if(plan.issues.begin(), plan.issues.end(),
                          [](const Issue& issue) { return issue.field == "door"; }),
            2);
  EXPECT_DOUBLE_EQ(plan.rooms[0].area_m2, 12.0);
  EXPECT_DOUBLE_EQ(plan.rooms[1].area_m2, 8.0);
  EXPECT_TRUE(plan.doors.empty());
}

TEST(Merge, CorridorsMayMeetInALobbyButAnOpenOfficeIsAHall) {
  const Ring crossing = {{0, 20},  {18, 20}, {18, 18}, {20, 18}, {20, 0},  {22, 0},  {22, 18},
                         {24, 18}, {24, 20}, {42, 20}, {42, 22}, {24, 22}, {24, 24}, {22, 24},
                         {22, 42}, {20, 42}, {20, 24}, {18, 24}, {18, 22}, {0, 22}};
  const Ring office = {{100, 0}, {130, 0}, {130, 8}, {110, 8}, {110, 6}, {100, 6}};
  const FloorPlan plan = merge({outline(1, 1, crossing), outline(2, 2, office)}, {}, {});
  EXPECT_EQ(plan.rooms[0].kind, RoomKind::corridor);
  EXPECT_EQ(plan.rooms[1].kind, RoomKind::hall);
}

TEST(Merge, TellsCorridorsAndHallsFromRooms) {
  const Ring l_shaped = {{0, 20}, {22, 20}, {22, 40}, {20, 40}, {20, 22}, {0, 22}};
  const PlacedOutline loop{5, 5, {rectangle(50, 0, 70, 20), {rectangle(52, 2, 68, 18)}}};
  const FloorPlan plan =
      merge({outline(1, 1, rectangle(0, 0, 12, 2)), outline(2, 2, rectangle(0, 4, 5, 8)),
             outline(3, 3, rectangle(15, 4, 25, 14)), outline(4, 4, l_shaped), loop},
            {}, {});
  std::vector<std::string> kinds;
  for (const PlanRoom& room : plan.rooms) kinds.emplace_back(to_string(room.kind));
  EXPECT_THAT(kinds, testing::ElementsAre("corridor", "room", "hall", "corridor", "corridor"));
}

/// Everything that a plan says, to the last digit.
std::string described(const FloorPlan& plan) {
  std::ostringstream text;
  text.precision(17);
  const auto write = [&](const Ring& ring) {
    for (const Point2& point : ring) text << point.x() << ' ' << point.y() << ", ";
    text << '\n';
  };
  const auto write_all = [&](const std::vector<Polygon>& polygons) {
    for (const Polygon& polygon : polygons) {
      write(polygon.outer);
      for (const Ring& hole : polygon.holes) write(hole);
    }
  };
  for (const PlanRoom& room : plan.rooms) {
    text << room.id << to_string(room.kind) << room.area_m2 << room.asrs.size() << '\n';
    write_all(room.parts);
  }
  for (const PlanDoor& door : plan.doors) {
    text << door.id << door.room_a.value_or(0) << door.room_b.value_or(0) << '\n';
    write(door.opening);
  }
  write_all(plan.walls);
  write_all(plan.free_space);
  for (const Issue& issue : plan.issues) text << to_string(issue) << '\n';
  return text.str();
}

TEST(Merge, TheOrderOfTheInputDoesNotMatter) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> noise(-0.3, 0.3);
  std::vector<PlacedOutline> outlines;
  std::vector<Door> doors;
  for (int i = 0; i < 12; ++i) {
    const double x = i % 4 * 4.0;
    const double y = i / 4 * 3.0;
    outlines.push_back(outline(i + 1, i % 9 + 1,
                               {{x + noise(random), y + noise(random)},
                                {x + 4 + noise(random), y + noise(random)},
                                {x + 4 + noise(random), y + 3 + noise(random)},
                                {x + noise(random), y + 3 + noise(random)}}));
    doors.push_back(door_between({{x, y + 1}, {x, y + 2}}, i % 9 + 1, std::nullopt));
  }
  const std::string expected = described(merge(outlines, doors, {}));
  for (int round = 0; round < 10; ++round) {
    std::shuffle(outlines.begin(), outlines.end(), random);
    std::shuffle(doors.begin(), doors.end(), random);
    EXPECT_EQ(described(merge(outlines, doors, {})), expected);
  }
}

TEST(Merge, WithoutWallThicknessThereAreNoWalls) {
  EXPECT_TRUE(merge(two_rooms(), {kDoor}, {.wall_thickness_m = 0.0}).walls.empty());
}

}  // namespace
}  // namespace roomatlas
