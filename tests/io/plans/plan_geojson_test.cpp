// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "io/plan_file.hpp"
#include "roomatlas/core/issue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace roomatlas {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing_io::read_plan_text;

constexpr double kMillimetre = 0.001;

void expect_near(const Point2& actual, const Point2& expected) {
  EXPECT_NEAR(actual.x(), expected.x(), kMillimetre);
  EXPECT_NEAR(actual.y(), expected.y(), kMillimetre);
}

void expect_near(const Ring& actual, const Ring& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) expect_near(actual[i], expected[i]);
}

void expect_near(const std::vector<Polygon>& actual, const std::vector<Polygon>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    expect_near(actual[i].outer, expected[i].outer);
    ASSERT_EQ(actual[i].holes.size(), expected[i].holes.size());
    for (std::size_t hole = 0; hole < actual[i].holes.size(); ++hole) {
      expect_near(actual[i].holes[hole], expected[i].holes[hole]);
    }
  }
}

void expect_near(const PlanRoom& actual, const PlanRoom& expected) {
  EXPECT_EQ(actual.id, expected.id);
  EXPECT_EQ(actual.name, expected.name);
  EXPECT_EQ(actual.kind, expected.kind);
  EXPECT_EQ(actual.asrs, expected.asrs);
  EXPECT_NEAR(actual.area_m2, expected.area_m2, kMillimetre);
  expect_near(actual.label_point, expected.label_point);
  expect_near(actual.parts, expected.parts);
}

void expect_near(const PlanDoor& actual, const PlanDoor& expected) {
  EXPECT_EQ(actual.id, expected.id);
  EXPECT_NEAR(actual.width_m, expected.width_m, kMillimetre);
  EXPECT_EQ(actual.room_a, expected.room_a);
  EXPECT_EQ(actual.room_b, expected.room_b);
  expect_near(actual.jambs.a, expected.jambs.a);
  expect_near(actual.jambs.b, expected.jambs.b);
  expect_near(actual.opening, expected.opening);
}

/// One of everything: a hole, a room in two parts, doors with two, one and no known room.
FloorPlan small_plan() {
  FloorPlan plan;
  plan.title = "Größe \"B\"";
  const Polygon hall{{{0, 0}, {6.00044, 0}, {6, 4.12345}, {0, 4}},
                     {{{2, 2}, {2, 3}, {3, 3}, {3, 2}}}};
  const Polygon east{{{7, 0}, {9, 0}, {9, 2}}, {}};
  const Polygon west{{{-3, -1}, {-1, -1}, {-1, 1.0 / 3.0}}, {}};
  plan.rooms = {{1, "Hall", RoomKind::hall, {hall}, 23.1, {1, 1}, {1, 4}},
                {2, "2", RoomKind::corridor, {east}, 2.0, {8, 0.5}, {}},
                {7, "Büro", RoomKind::room, {east, west}, 3.3333, {8, 0.5}, {2, 3}}};
  const Ring opening = {{6, 1}, {7, 1}, {7, 1.9}, {6, 1.9}};
  const DoorKind door = DoorKind::door;
  const auto none = std::nullopt;
  plan.doors = {{1, {{6.5, 1}, {6.5, 1.9}}, 0.9, opening, 1, 2, door, none},
                {2, {{0, 1}, {0, 1.9}}, 0.9, {}, 7, none, door, none},
                {3, {{0, 2}, {0, 2.8}}, 0.8, opening, none, none, door, none}};
  plan.walls = {hall, east};
  plan.furniture = {{west, FurnitureKind::free_standing}};
  return plan;
}

TEST(PlanGeojson, ReadingWhatWasWrittenGivesThePlanBackToAMillimetre) {
  const FloorPlan plan = small_plan();
  const FloorPlan read = read_plan_text(to_geojson(plan));
  EXPECT_EQ(read.title, plan.title);
  ASSERT_EQ(read.rooms.size(), plan.rooms.size());
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) expect_near(read.rooms[i], plan.rooms[i]);
  ASSERT_EQ(read.doors.size(), plan.doors.size());
  for (std::size_t i = 0; i < plan.doors.size(); ++i) expect_near(read.doors[i], plan.doors[i]);
  expect_near(read.walls, plan.walls);
  expect_near(outlines_of(read.furniture), outlines_of(plan.furniture));
  EXPECT_TRUE(read.free_space.empty());
}

TEST(PlanGeojson, WritingWhatWasReadGivesTheSameBytes) {
  const std::string text = to_geojson(small_plan());
  EXPECT_EQ(to_geojson(small_plan()), text);
  EXPECT_EQ(to_geojson(read_plan_text(text)), text);
}

TEST(PlanGeojson, WhatADoorAndAPieceOfFurnitureAreIsKeptWhereItDiffersFromTheDefault) {
  FloorPlan plan = small_plan();
  EXPECT_THAT(to_geojson(plan), AllOf(Not(HasSubstr("leaf")), Not(HasSubstr("opening")),
                                      Not(HasSubstr("free_standing"))));
  plan.doors[0].leaf = Segment2{{6.5, 1}, {7.3, 1.2}};
  plan.doors[1].kind = DoorKind::window;
  plan.doors[2].kind = DoorKind::passage;
  plan.furniture[0].kind = FurnitureKind::against_wall;
  const std::string text = to_geojson(plan);
  EXPECT_THAT(
      text, AllOf(HasSubstr(R"("leaf":[[6.5,1.0],[7.3,1.2]])"), HasSubstr(R"("opening":"window")"),
                  HasSubstr(R"("opening":"passage")"), HasSubstr(R"("furniture":"against_wall")")));
  const FloorPlan read = read_plan_text(text);
  ASSERT_TRUE(read.doors[0].leaf);
  expect_near(read.doors[0].leaf->a, {6.5, 1});
  expect_near(read.doors[0].leaf->b, {7.3, 1.2});
  EXPECT_FALSE(read.doors[1].leaf);
  EXPECT_EQ(read.doors[0].kind, DoorKind::door);
  EXPECT_EQ(read.doors[1].kind, DoorKind::window);
  EXPECT_EQ(read.doors[2].kind, DoorKind::passage);
  EXPECT_EQ(read.furniture[0].kind, FurnitureKind::against_wall);
  EXPECT_EQ(to_geojson(read), text);
}

TEST(PlanGeojson, AnEmptyPlanIsAnEmptyCollection) {
  const FloorPlan read = read_plan_text(to_geojson({}));
  EXPECT_TRUE(read.rooms.empty());
  EXPECT_TRUE(read.title.empty());
}

TEST(PlanGeojson, CoordinatesAreRoundedToTheMillimetre) {
  FloorPlan plan;
  plan.walls = {{{{0.00049, -0.0001}, {1.23456, 0}, {1, 2}}, {}}};
  EXPECT_THAT(to_geojson(plan), HasSubstr("[[[0.0,0.0],[1.235,0.0],[1.0,2.0],[0.0,0.0]]]"));
}

TEST(PlanGeojson, OuterRingsAreWrittenCounterClockwiseAndHolesClockwise) {
  FloorPlan plan;
  plan.walls = {{{{0, 0}, {0, 9}, {9, 9}, {9, 0}}, {{{1, 1}, {2, 1}, {2, 2}}}}};
  const Polygon wall = read_plan_text(to_geojson(plan)).walls.at(0);
  EXPECT_GT(signed_area(wall.outer), 0.0);
  EXPECT_LT(signed_area(wall.holes.at(0)), 0.0);
  EXPECT_EQ(wall.outer.front(), Point2(0, 0));
}

TEST(PlanGeojson, ARingThatCollapsesAtTheMillimetreIsLeftOut) {
  FloorPlan plan;
  plan.walls = {{{{0, 0}, {0.0001, 0}, {0, 0.0001}}, {}},
                {{{0, 0}, {1, 0}, {1, 1}}, {{{0.5, 0.2}, {0.5, 0.2001}, {0.5001, 0.2}}}}};
  const FloorPlan read = read_plan_text(to_geojson(plan));
  ASSERT_EQ(read.walls.size(), 1U);
  EXPECT_TRUE(read.walls[0].holes.empty());
}

TEST(PlanGeojson, CarriesSimpleIndoorTags) {
  const std::string text = to_geojson(small_plan());
  EXPECT_THAT(text, AllOf(HasSubstr("\"indoor\":\"room\",\"ref\":\"7\""),
                          HasSubstr("\"indoor\":\"corridor\""), HasSubstr("\"indoor\":\"area\""),
                          HasSubstr("\"indoor\":\"door\""), HasSubstr("\"indoor\":\"wall\"")));
}

TEST(PlanGeojson, RefusesToWriteWhatIsNotFinite) {
  FloorPlan plan;
  plan.walls = {{{{0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0}, {1, 1}}, {}}};
  EXPECT_THROW((void)to_geojson(plan), InputError);
}

TEST(PlanGeojson, WhatIsMissingIsDerivedWhereItCanBe) {
  const FloorPlan plan = read_plan_text(testing_io::collection(R"(
    {"type": "Feature", "properties": {"kind": "room", "id": 4},
     "geometry": {"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,3],[0,3],[0,0]]]}},
    {"type": "Feature", "properties": {"kind": "door", "id": 1, "jambs": [[0,0],[0,0.8]]},
     "geometry": null})"));
  ASSERT_EQ(plan.rooms.size(), 1U);
  EXPECT_EQ(plan.rooms[0].name, "4");
  EXPECT_DOUBLE_EQ(plan.rooms[0].area_m2, 12.0);
  EXPECT_TRUE(contains(plan.rooms[0].parts[0], plan.rooms[0].label_point));
  ASSERT_EQ(plan.doors.size(), 1U);
  EXPECT_DOUBLE_EQ(plan.doors[0].width_m, 0.8);
  EXPECT_FALSE(plan.doors[0].room_a.has_value());
}

TEST(PlanGeojson, RoomsOfADoorAreOrdered) {
  std::string text = to_geojson(small_plan());
  text.replace(text.find("\"rooms\":[1,2]"), 13, "\"rooms\":[2,1]");
  const FloorPlan plan = read_plan_text(text);
  EXPECT_EQ(plan.doors[0].room_a, 1);
  EXPECT_EQ(plan.doors[0].room_b, 2);
}

}  // namespace
}  // namespace roomatlas
