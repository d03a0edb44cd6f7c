// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/maps/world_raster.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/simulate/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include "support/shipped_world.hpp"

namespace roomatlas {
namespace {

using testing_io::WorldRaster;

std::vector<std::string> shipped_worlds() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(test::kWorlds)) {
    if (entry.path().extension() == ".geojson") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

const WorldRaster& raster_of(const std::string& name) {
  static std::map<std::string, WorldRaster> rasters;
  if (!rasters.contains(name)) rasters.emplace(name, WorldRaster(test::shipped_world(name)));
  return rasters.at(name);
}

double width_of(const PlanRoom& room) { return bounds(room.parts[0].outer).size().minCoeff(); }

/// Rooms less one, less the doors that are needed to join them: 0 in a tree.
std::size_t loops_of(const FloorPlan& world) { return world.doors.size() + 1 - world.rooms.size(); }

std::size_t doors_of(const FloorPlan& world, RoomId room) {
  return static_cast<std::size_t>(std::count_if(
      world.doors.begin(), world.doors.end(),
      [&](const PlanDoor& door) { return door.room_a == room || door.room_b == room; }));
}

class ShippedWorld : public testing::TestWithParam<std::string> {
 protected:
  const FloorPlan world_ = test::shipped_world(GetParam());
};

INSTANTIATE_TEST_SUITE_P(EveryOne, ShippedWorld, testing::ValuesIn(shipped_worlds()),
                         [](const auto& world) { return world.param; });

TEST_P(ShippedWorld, IsWrittenAsTheWriterWouldWriteIt) {
  std::ifstream stream(test::kWorlds / (GetParam() + ".geojson"), std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_EQ(to_geojson(world_), text.str());
}

TEST_P(ShippedWorld, NoPointIsInTwoRoomsOrInARoomAndAWall) {
  const WorldRaster& raster = raster_of(GetParam());
  EXPECT_EQ(raster.count([](const auto& cell) { return cell.rooms + cell.doors + cell.walls > 1; }),
            0);
}

TEST_P(ShippedWorld, FurnitureStandsInRoomsAndNowhereElse) {
  const WorldRaster& raster = raster_of(GetParam());
  EXPECT_EQ(raster.count([](const auto& cell) {
    return cell.furniture > 1 ||
           (cell.furniture == 1 && (cell.rooms != 1 || cell.walls + cell.doors > 0));
  }),
            0);
}

TEST_P(ShippedWorld, ARobotReachesEveryRoomAndCannotLeaveTheBuilding) {
  const WorldRaster& raster = raster_of(GetParam());
  const double clearance_m = 0.31;  // half the diagonal of 0.45 x 0.40 m, and a little
  std::set<RoomId> entered;
  int outside = 0;
  raster.flood(world_.rooms.front().label_point, clearance_m, [&](const WorldRaster::Cell& cell) {
    if (cell.rooms > 0) entered.insert(cell.room);
    if (cell.rooms + cell.doors == 0) ++outside;
  });
  EXPECT_EQ(entered.size(), world_.rooms.size());
  EXPECT_EQ(outside, 0);
}

TEST_P(ShippedWorld, EveryDoorOpensBetweenTheTwoRoomsItNamesAndStandsInTheWall) {
  for (const PlanDoor& door : world_.doors) {
    const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
    const Point2 along = (door.jambs.b - door.jambs.a).normalized();
    const Point2 across(-along.y(), along.x());
    ASSERT_EQ(door.opening.size(), 4U) << "door " << door.id;
    const double thickness_m = std::abs(signed_area(door.opening)) / door.width_m;
    EXPECT_GE(thickness_m, 0.12) << "door " << door.id;
    EXPECT_LE(thickness_m, 0.25) << "door " << door.id;
    EXPECT_NEAR((door.jambs.b - door.jambs.a).norm(), door.width_m, 0.001);
    EXPECT_GE(door.width_m, 0.85);
    EXPECT_LE(door.width_m, 1.0);
    std::set<RoomId> touched;
    for (double share = -0.48; share <= 0.48; share += 0.06) {
      for (const double side : {-1.0, -0.9, -0.4, 0.0, 0.4, 0.9, 1.0}) {
        const Point2 point =
            middle + share * door.width_m * along +
            side * (thickness_m / 2.0 + (std::abs(side) == 1.0 ? 0.02 : 0.0)) * across;
        const auto cell = testing_io::covers_of(world_, point);
        EXPECT_EQ(cell.walls + cell.furniture, 0) << "door " << door.id;
        EXPECT_EQ(cell.rooms, std::abs(side) == 1.0 ? 1 : 0) << "door " << door.id;
        if (cell.rooms > 0) touched.insert(cell.room);
      }
    }
    ASSERT_TRUE(door.room_a && door.room_b) << "door " << door.id;
    EXPECT_EQ(touched, (std::set<RoomId>{*door.room_a, *door.room_b})) << "door " << door.id;
    for (const Point2& jamb :
         {Point2(door.jambs.a - 0.02 * along), Point2(door.jambs.b + 0.02 * along)}) {
      EXPECT_EQ(testing_io::covers_of(world_, jamb).walls, 1) << "door " << door.id;
    }
  }
}

TEST_P(ShippedWorld, DoorsJoinAllRooms) {
  std::map<RoomId, RoomId> group;
  for (const PlanRoom& room : world_.rooms) group[room.id] = room.id;
  for (const PlanDoor& door : world_.doors) {
    const RoomId from = group[door.room_a.value()];
    const RoomId to = group[door.room_b.value()];
    for (auto& [room, name] : group) {
      if (name == from) name = to;
    }
  }
  for (const auto& [room, name] : group) EXPECT_EQ(name, group.begin()->second) << "room " << room;
}

TEST_P(ShippedWorld, HasNothingToBeSaidAboutButAHallWithoutDoors) {
  for (const Issue& issue : check_world(world_)) {
    EXPECT_TRUE(GetParam() == "open_hall" && issue.severity == Severity::note) << to_string(issue);
  }
}

TEST_P(ShippedWorld, NamesNumbersAndSizesBelongToTheirRooms) {
  for (std::size_t i = 0; i < world_.rooms.size(); ++i) {
    const PlanRoom& room = world_.rooms[i];
    EXPECT_EQ(room.id, static_cast<RoomId>(i + 1));
    EXPECT_FALSE(room.name.empty());
    EXPECT_NEAR(room.area_m2, area(room.parts.at(0)), 0.001) << room.name;
    EXPECT_TRUE(contains(room.parts[0], room.label_point)) << room.name;
  }
}

TEST(ShippedWorlds, FurnitureOfTheLargerWorldsStandsClearOfTheDoors) {
  for (const char* name : {"nine_rooms", "afit_floor"}) {
    const FloorPlan world = test::shipped_world(name);
    EXPECT_GE(world.furniture.size(), 5U);
    for (const Polygon& piece : outlines_of(world.furniture)) {
      for (const PlanDoor& door : world.doors) {
        for (const Point2& corner : door.opening) {
          EXPECT_GE(distance_to_boundary(piece.outer, corner), 1.2) << "door " << door.id;
        }
      }
    }
  }
}

TEST(ShippedWorlds, TwoRoomsAreJoinedByOneDoor) {
  const FloorPlan world = test::shipped_world("two_rooms");
  EXPECT_EQ(world.rooms.size(), 2U);
  EXPECT_EQ(world.doors.size(), 1U);
}

TEST(ShippedWorlds, NineRoomsHasALoopAndADoorBetweenRoomsFiveAndSix) {
  const FloorPlan world = test::shipped_world("nine_rooms");
  EXPECT_EQ(world.rooms.size(), 9U);
  EXPECT_GE(loops_of(world), 1U);
  EXPECT_EQ(
      std::count_if(world.doors.begin(), world.doors.end(),
                    [](const PlanDoor& door) { return door.room_a == 5 && door.room_b == 6; }),
      1);
}

TEST(ShippedWorlds, TheAfitFloorHasItsSizeItsRoomsAndItsLoops) {
  const FloorPlan world = test::shipped_world("afit_floor");
  Box2 box;
  for (const Polygon& wall : world.walls) {
    for (const Point2& corner : wall.outer) box.extend(corner);
  }
  EXPECT_NEAR(box.size().x(), 78.0, 1e-9);
  EXPECT_NEAR(box.size().y(), 78.0, 1e-9);

  int rooms = 0;
  int ordinary = 0;
  int with_two_doors = 0;
  std::size_t corridor_doors = 0;
  std::set<RoomId> corridors;
  for (const PlanRoom& room : world.rooms) {
    if (room.kind == RoomKind::corridor) {
      corridors.insert(room.id);
      EXPECT_GE(width_of(room), 2.0) << room.name;
      EXPECT_LE(width_of(room), 2.6) << room.name;
      continue;
    }
    ++rooms;
    EXPECT_GE(room.area_m2, 12.0) << room.name;
    EXPECT_LE(room.area_m2, 100.0) << room.name;
    if (room.area_m2 <= 80.0) ++ordinary;
    if (doors_of(world, room.id) >= 2) ++with_two_doors;
  }
  for (const PlanDoor& door : world.doors) {
    if (corridors.contains(*door.room_a) && corridors.contains(*door.room_b)) ++corridor_doors;
  }
  EXPECT_GE(rooms, 40);
  EXPECT_GE(ordinary, rooms * 8 / 10);
  EXPECT_GE(with_two_doors, 8);
  EXPECT_EQ(corridor_doors + 1 - corridors.size(), 2U) << "a figure of eight has two loops";
}

TEST(ShippedWorlds, TenIdenticalRoomsDifferInPlaceOnly) {
  const FloorPlan world = test::shipped_world("identical_rooms");
  int rooms = 0;
  for (const PlanRoom& room : world.rooms) {
    if (room.kind == RoomKind::corridor) continue;
    ++rooms;
    const Point2 size = bounds(room.parts[0].outer).size();
    EXPECT_NEAR(size.x(), 4.8, 1e-9);
    EXPECT_NEAR(size.y(), 4.8, 1e-9);
    EXPECT_EQ(room.parts[0].outer.size(), 4U);
    EXPECT_EQ(doors_of(world, room.id), 1U);
  }
  EXPECT_EQ(rooms, 10);
}

TEST(ShippedWorlds, TheCurvedWallTurnsByAtMostTenDegreesAndTheWingStandsAtThirty) {
  const FloorPlan world = test::shipped_world("slanted_and_curved");
  const auto ring_of = [&](const std::string& name) {
    return std::find_if(world.rooms.begin(), world.rooms.end(),
                        [&](const PlanRoom& room) { return room.name == name; })
        ->parts.at(0)
        .outer;
  };
  const Ring apse = ring_of("Apse");
  int gentle_turns = 0;
  for (std::size_t i = 0; i < apse.size(); ++i) {
    const Point2 u = apse[(i + 1) % apse.size()] - apse[i];
    const Point2 v = apse[(i + 2) % apse.size()] - apse[(i + 1) % apse.size()];
    const double turn_deg = degrees(std::atan2(cross(u, v), u.dot(v)));
    if (turn_deg < 45.0) {
      ++gentle_turns;
      EXPECT_LE(turn_deg, 10.0);
    }
  }
  EXPECT_GE(gentle_turns, 18);
  const Ring wing = ring_of("Wing 1");
  const Point2 side = wing[1] - wing[0];
  EXPECT_NEAR(degrees(std::atan2(side.y(), side.x())), 30.0, 0.05);
}

TEST(ShippedWorlds, TheOpenHallHasPillarsAndNoDoors) {
  const FloorPlan world = test::shipped_world("open_hall");
  ASSERT_EQ(world.rooms.size(), 1U);
  EXPECT_EQ(world.rooms[0].kind, RoomKind::hall);
  EXPECT_TRUE(world.doors.empty());
  EXPECT_GE(world.rooms[0].parts.at(0).holes.size(), 4U);
}

}  // namespace
}  // namespace roomatlas
