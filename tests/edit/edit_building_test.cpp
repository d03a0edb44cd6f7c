// SPDX-License-Identifier: GPL-3.0-or-later
// Each kind of statement on a building of two rooms, A of 4 m x 3 m and B of 6 m x 3 m right of it,
// 0.2 m of wall between them and a door of 1 m in it. Areas are told by hand.
#include "roomatlas/edit/edit_building.hpp"

#include <gmock/gmock.h>

#include "roomatlas/merge/merge.hpp"

namespace roomatlas {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Polygon box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

MappedBuilding two_rooms() {
  MappedBuilding building;
  building.is_drafted = true;
  building.room_of_asr = {{1, 1}, {2, 2}};
  building.outlines = {{1, 1, box(0, 0, 4, 3)}, {2, 2, box(4.2, 0, 10.2, 3)}};
  building.measured_outlines = building.outlines;
  Door door = door_between({{4.1, 1.0}, {4.1, 2.0}}, 2, 1);
  door.is_driven = true;
  building.doors = {door};
  building.furniture = {{box(6, 1, 7, 2), FurnitureKind::free_standing}};
  building.edges = {{1, {{4, 0}, {4, 1}}, WallEvidence::measured, 0.01}};
  return building;
}

Edit edit_of(EditKind kind) {
  Edit edit;
  edit.kind = kind;
  return edit;
}

RoomAnchor room_at(double x, double y) { return {std::nullopt, Point2(x, y), {}}; }

double area_of(const MappedBuilding& building, RoomId room) {
  double sum = 0.0;
  for (const PlanRoom& one :
       merge(building.outlines, building.doors, {}, building.wall_bodies).rooms) {
    if (one.id == room) sum += one.area_m2;
  }
  return sum;
}

TEST(EditBuilding, NamesAndKindsGoToTheRoomAtThePlace) {
  MappedBuilding building = two_rooms();
  Edit name = edit_of(EditKind::name_room);
  name.rooms = {room_at(5, 1)};
  name.name = "Kitchen";
  Edit kind = edit_of(EditKind::set_room_kind);
  kind.rooms = {room_at(1, 1)};
  kind.room_kind = RoomKind::hall;
  EXPECT_THAT(edit_building({name, kind}, building), IsEmpty());
  EXPECT_EQ(building.names, (std::map<RoomId, std::string>{{2, "Kitchen"}}));
  EXPECT_EQ(building.kinds, (std::map<RoomId, RoomKind>{{1, RoomKind::hall}}));
}

TEST(EditBuilding, AnOutlineThatTheRoomNoLongerHasIsSaidAndNothingIsDone) {
  MappedBuilding building = two_rooms();
  Edit name = edit_of(EditKind::name_room);
  name.rooms = {{7, Point2(5, 1), box(4.2, 0, 5.2, 3).outer}};
  name.name = "Closet";
  const Issues issues = edit_building({name}, building);
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_EQ(issues[0].field, "edits[0] name_room");
  EXPECT_THAT(issues[0].message, HasSubstr("room 7 was has another shape now: 3 m2 of 3 are"));
  EXPECT_THAT(building.names, IsEmpty());
  name.rooms = {room_at(40, 40)};
  EXPECT_THAT(edit_building({name}, building).at(0).message, HasSubstr("no room lies any more"));
}

TEST(EditBuilding, JoinedRoomsAreOneWithTheOpeningBetween) {
  MappedBuilding building = two_rooms();
  Edit join = edit_of(EditKind::join_rooms);
  join.rooms = {room_at(1, 1), room_at(5, 1)};
  EXPECT_THAT(edit_building({join}, building), IsEmpty());
  EXPECT_NEAR(area_of(building, 2), 12.0 + 18.0 + 0.2 * 1.0, 1e-6);
  EXPECT_THAT(building.doors, IsEmpty());
  EXPECT_EQ(building.room_of_asr.at(1), 2);
  EXPECT_THAT(edit_building({join}, building).at(0).message, HasSubstr("in one room already"));
}

TEST(EditBuilding, RoomsWithNothingOpenBetweenThemAreNotJoined) {
  MappedBuilding building = two_rooms();
  building.doors.clear();
  Edit join = edit_of(EditKind::join_rooms);
  join.rooms = {room_at(1, 1), room_at(5, 1)};
  EXPECT_THAT(edit_building({join}, building).at(0).message, HasSubstr("nothing is open"));
  EXPECT_NEAR(area_of(building, 1), 12.0, 1e-6);
}

TEST(EditBuilding, ASplitLeavesTwoRoomsThatTogetherAreTheOne) {
  MappedBuilding building = two_rooms();
  Edit split = edit_of(EditKind::split_room);
  split.rooms = {room_at(5, 1)};
  split.line = {{8.2, 0.1}, {8.2, 2.9}};
  EXPECT_THAT(edit_building({split}, building), IsEmpty());
  constexpr double kInOpening_m2 = 0.075 * 3.0;  // a passage is drawn as deep as a wall
  EXPECT_NEAR(area_of(building, 2), 4.0 * 3.0 - kInOpening_m2, 1e-6);
  EXPECT_NEAR(area_of(building, 3), 2.0 * 3.0 - kInOpening_m2, 1e-6);
  ASSERT_EQ(building.doors.size(), 2U);
  EXPECT_EQ(building.doors[1].kind, DoorKind::passage);
  EXPECT_NEAR(building.doors[1].width_m, 3.0, 1e-6);
  EXPECT_EQ(building.doors[0].room_a, 2);
}

TEST(EditBuilding, ASplitByAWallLeavesOutTheWall) {
  MappedBuilding building = two_rooms();
  Edit split = edit_of(EditKind::split_room);
  split.rooms = {room_at(5, 1)};
  split.line = {{8.2, 0.0}, {8.2, 3.0}};
  split.thickness_m = 0.2;
  EXPECT_THAT(edit_building({split}, building), IsEmpty());
  EXPECT_NEAR(area_of(building, 2), 3.9 * 3.0, 1e-6);
  EXPECT_NEAR(area_of(building, 3), 1.9 * 3.0, 1e-6);
  EXPECT_EQ(building.doors.size(), 1U);
}

TEST(EditBuilding, ALineThatDoesNotReachTheWallsSplitsNothing) {
  MappedBuilding building = two_rooms();
  Edit split = edit_of(EditKind::split_room);
  split.rooms = {room_at(5, 1)};
  split.line = {{8.2, 1.0}, {8.2, 2.0}};
  EXPECT_THAT(edit_building({split}, building).at(0).message, HasSubstr("leaves 1 parts"));
  EXPECT_EQ(building.outlines.size(), 2U);
}

TEST(EditBuilding, DoorsAreShutOpenedAndAdded) {
  MappedBuilding building = two_rooms();
  Edit shut = edit_of(EditKind::shut_door);
  shut.at = {4.1, 1.4};
  EXPECT_THAT(edit_building({shut}, building), IsEmpty());
  EXPECT_THAT(building.doors, IsEmpty());
  EXPECT_THAT(edit_building({shut}, building).at(0).message, HasSubstr("no door or opening"));
  Edit add = edit_of(EditKind::add_door);
  add.line = {{4.1, 0.2}, {4.1, 1.0}};
  EXPECT_THAT(edit_building({add}, building), IsEmpty());
  ASSERT_EQ(building.doors.size(), 1U);
  EXPECT_EQ(building.doors[0].room_a.value() + building.doors[0].room_b.value(), 3);
  EXPECT_THAT(edit_building({add}, building).at(0).message, HasSubstr("there already"));
  add.line = {{10.3, 0.2}, {10.3, 1.0}};
  EXPECT_THAT(edit_building({add}, building).at(0).message, HasSubstr("one side"));
}

TEST(EditBuilding, AShutDoorThatIsOpenedAgainIsAsItWas) {
  MappedBuilding building = two_rooms();
  Edit shut = edit_of(EditKind::shut_door);
  shut.at = {4.1, 1.5};
  Edit open = shut;
  open.kind = EditKind::open_door;
  EXPECT_THAT(edit_building({shut, open}, building), IsEmpty());
  EXPECT_EQ(building.doors.size(), 1U);
  EXPECT_THAT(edit_building({open}, building).at(0).message, HasSubstr("open already"));
  building.doors[0].kind = DoorKind::window;
  EXPECT_THAT(edit_building({open}, building), IsEmpty());
  EXPECT_EQ(building.doors[0].kind, DoorKind::door);
}

TEST(EditBuilding, AMovedWallGivesOneRoomWhatItTakesFromTheOther) {
  MappedBuilding building = two_rooms();
  Edit move = edit_of(EditKind::move_wall);
  move.line = {{4.1, 0.0}, {4.1, 3.0}};
  move.by_m = -0.3;  // to the right of its way up: into B
  EXPECT_THAT(edit_building({move}, building), IsEmpty());
  EXPECT_NEAR(area_of(building, 1), 12.0 + 0.9, 1e-6);
  EXPECT_NEAR(area_of(building, 2), 18.0 - 0.9, 1e-6);
  EXPECT_NEAR(building.doors[0].jambs.a.x(), 4.4, 1e-9);
  for (const PlanEdge& edge : building.edges) EXPECT_EQ(edge.evidence, WallEvidence::inferred);
}

/// The lower wall of B rises by 7.5 mm a metre from 1 mm below the told line's end: a sliver of a
/// hand's length and 1 mm is left in the corner.
TEST(EditBuilding, AMovedWallMayEndAtACornerThatIsNotSquare) {
  MappedBuilding building = two_rooms();
  building.outlines[1].outline.outer = {{4.2, -0.001}, {10.2, 0.044}, {10.2, 3}, {4.2, 3}};
  Edit move = edit_of(EditKind::move_wall);
  move.line = {{4.1, 0}, {4.1, 3}};
  move.by_m = -0.2;
  EXPECT_THAT(edit_building({move}, building), IsEmpty());
  EXPECT_NEAR(area_of(building, 1), 12.6, 1e-9);
  EXPECT_NEAR(area_of(building, 2), 6.0 * 3.0 - 6.0 * 0.0215 - 0.6, 2e-3);
}

/// The told line leans against the wall by 5 mm at its end, as one that was drawn does.
TEST(EditBuilding, AMovedWallNeedNotBeToldToTheMillimetre) {
  for (const double by_m : {0.2, -0.2}) {
    MappedBuilding building = two_rooms();
    Edit move = edit_of(EditKind::move_wall);
    move.line = {{4.1, 0}, {4.105, 3}};
    move.by_m = by_m;
    EXPECT_THAT(edit_building({move}, building), IsEmpty());
    EXPECT_NEAR(area_of(building, 1), 12.0 - 3.0 * by_m, 0.01);
    EXPECT_NEAR(area_of(building, 2), 18.0 + 3.0 * by_m, 0.01);
  }
}

TEST(EditBuilding, AWallThatIsNotThereIsNotMoved) {
  MappedBuilding building = two_rooms();
  Edit move = edit_of(EditKind::move_wall);
  move.line = {{7.1, 0.5}, {7.1, 2.5}};
  move.by_m = 0.2;
  EXPECT_THAT(edit_building({move}, building).at(0).message, HasSubstr("no wall runs along"));
}

TEST(EditBuilding, FurnitureBecomesWallAndWallFurniture) {
  MappedBuilding building = two_rooms();
  Edit wall = edit_of(EditKind::furniture_to_wall);
  wall.at = {6.5, 1.5};
  EXPECT_THAT(edit_building({wall}, building), IsEmpty());
  EXPECT_THAT(building.furniture, IsEmpty());
  EXPECT_NEAR(area_of(building, 2), 17.0, 1e-6);
  EXPECT_THAT(edit_building({wall}, building).at(0).message, HasSubstr("no furniture"));
  Edit back = edit_of(EditKind::wall_to_furniture);
  back.at = {6.5, 1.5};
  EXPECT_THAT(edit_building({back}, building), IsEmpty());
  EXPECT_NEAR(area_of(building, 2), 18.0, 1e-6);
  ASSERT_EQ(building.furniture.size(), 1U);
  EXPECT_NEAR(area(building.furniture[0].outline), 1.0, 1e-6);
}

TEST(EditBuilding, WallBecomesFurnitureAsDeepAsFurnitureIsAndNoDeeper) {
  const auto told = [](const Polygon& outline, const Point2& at) {
    MappedBuilding building = two_rooms();
    Edit edit = edit_of(EditKind::wall_to_furniture);
    edit.outline = outline.outer;
    edit.at = at;
    const Issues issues = edit_building({edit}, building);
    return std::make_pair(issues.empty() ? "" : issues[0].message, area_of(building, 1));
  };
  EXPECT_NEAR(told(box(1, 3, 2, 3.6), {1.5, 3.3}).second, 12.6, 1e-6);  // a wardrobe at the wall
  const auto [deep, same_m2] = told(box(-50, -50, 50, 50), {0, 0});
  EXPECT_THAT(deep, HasSubstr("more than 2 m beyond the floor of room"));
  EXPECT_NEAR(same_m2, 12.0, 1e-6);
  EXPECT_THAT(told(box(1, 3, 2, 3.6), {8, 1}).first, HasSubstr("at_m is not in its outline_m"));
}

TEST(EditBuilding, WallInsideOfARingOfFloorIsAsFarFromItsInnerSideAsFromItsOuter) {
  Polygon ring = box(0, 0, 20, 20);
  ring.holes = {box(3, 3, 17, 17).outer};
  std::reverse(ring.holes[0].begin(), ring.holes[0].end());
  const auto told = [&](const Polygon& outline, const Point2& at) {
    MappedBuilding building = two_rooms();
    building.outlines = {{1, 1, ring}};
    building.doors.clear();
    building.edges.clear();
    Edit edit = edit_of(EditKind::wall_to_furniture);
    edit.outline = outline.outer;
    edit.at = at;
    const Issues issues = edit_building({edit}, building);
    return std::make_pair(issues.empty() ? "" : issues[0].message, area_of(building, 1));
  };
  const double floor_m2 = 20.0 * 20.0 - 14.0 * 14.0;
  const auto [none, shelved_m2] = told(box(8, 3, 10, 3.5), {9, 3.2});
  EXPECT_EQ(none, "");
  EXPECT_NEAR(shelved_m2, floor_m2 + 1.0, 1e-6);
  for (const Polygon& core : {box(2.9, 2.9, 17.1, 17.1), Polygon{}}) {  // told, and as a hole
    const auto [deep, same_m2] = told(core, {10, 10});
    EXPECT_THAT(deep, HasSubstr("more than 2 m beyond the floor of room 1"));
    EXPECT_NEAR(same_m2, floor_m2, 1e-6);
  }
}

TEST(EditBuilding, ADoorIsNoWiderThanAGateAndLiesOverNoOther) {
  MappedBuilding building = two_rooms();
  building.outlines = {{1, 1, box(0, 0, 4, 30)}, {2, 2, box(4.2, 0, 10.2, 30)}};
  Edit add = edit_of(EditKind::add_door);
  add.line = {{4.1, 10}, {4.1, 16}};
  EXPECT_THAT(edit_building({add}, building).at(0).message, HasSubstr("at most 4 m wide"));
  add.line = {{4.1, 1.2}, {4.1, 4.8}};  // its middle is far from the door of before
  EXPECT_THAT(edit_building({add}, building).at(0).message, HasSubstr("a door is there already"));
  EXPECT_EQ(building.doors.size(), 1U);
  building.doors[0].kind = DoorKind::window;
  EXPECT_THAT(edit_building({add}, building).at(0).message, HasSubstr("a window is there already"));
}

TEST(EditBuilding, ARoomThatLosesItsNameToAnotherIsTold) {
  MappedBuilding building = two_rooms();
  Edit first = edit_of(EditKind::name_room);
  first.name = "Lab";
  first.rooms = {room_at(1, 1)};
  Edit second = first;
  second.rooms = {room_at(5, 1)};
  const Issues issues = edit_building({first, second}, building);
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_THAT(issues[0].message, HasSubstr("the name was room 1's"));
  EXPECT_EQ(building.names, (std::map<RoomId, std::string>{{2, "Lab"}}));
  EXPECT_THAT(edit_building({second}, building), IsEmpty());  // said again
}

TEST(EditBuilding, RoomsToldByNumberGetThePlaceThatTheyHave) {
  PlanRoom room;
  room.id = 5;
  room.parts = {box(0, 0, 2, 2)};
  room.label_point = {1, 1};
  Edit name = edit_of(EditKind::name_room);
  name.rooms = {{5, std::nullopt, {}}};
  EXPECT_EQ(with_places({name}, {room})[0].rooms[0].outline.size(), 4U);
  name.rooms = {{6, std::nullopt, {}}};
  MappedBuilding building = two_rooms();
  EXPECT_THAT(edit_building(with_places({name}, {room}), building).at(0).message,
              HasSubstr("room 6 is not known"));
}

}  // namespace
}  // namespace roomatlas
