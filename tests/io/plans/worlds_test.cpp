// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/logs/drive.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/simulate/simulate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include "support/shipped_world.hpp"

namespace roomatlas {
namespace {

/// The worlds that have a drive, by name.
std::vector<std::string> world_names() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(test::kWorlds)) {
    if (entry.path().extension() == ".drive") names.insert(entry.path().stem().string());
  }
  return {names.begin(), names.end()};
}

Drive drive_of(const std::string& name) {
  std::ifstream stream(test::kWorlds / (name + ".drive"));
  Drive drive;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    Point2 point;
    if (words >> point.x() >> point.y()) drive.push_back(point);
  }
  return drive;
}

/// The true path, one pose a step.
std::vector<Pose2> true_path(const FloorPlan& world, const Drive& drive) {
  std::vector<Pose2> path;
  simulate(world, drive, {},
           [&](const SimulatedStep& step) { path.push_back(step.truth.world_from_robot); });
  return path;
}

using roomatlas::contains;

bool contains(const PlanRoom& room, const Point2& point) {
  return std::any_of(room.parts.begin(), room.parts.end(),
                     [&](const Polygon& part) { return contains(part, point); });
}

/// How many of the world's rooms, door openings and walls a point lies in.
int covers_of(const FloorPlan& world, const Point2& point) {
  int count = 0;
  for (const PlanRoom& room : world.rooms) count += contains(room, point) ? 1 : 0;
  for (const PlanDoor& door : world.doors) count += contains(door.opening, point) ? 1 : 0;
  for (const Polygon& wall : world.walls) count += contains(wall, point) ? 1 : 0;
  return count;
}

class World : public testing::TestWithParam<std::string> {
 protected:
  const FloorPlan world_ = read_plan(test::kWorlds / (GetParam() + ".geojson"));
  const Drive drive_ = drive_of(GetParam());
};

INSTANTIATE_TEST_SUITE_P(EveryOne, World, testing::ValuesIn(world_names()),
                         [](const auto& world) { return world.param; });

TEST_P(World, IsWrittenAsTheWriterWouldWriteIt) {
  std::ifstream stream(test::kWorlds / (GetParam() + ".geojson"), std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_EQ(to_geojson(world_), text.str());
}

TEST_P(World, RoomsDoorsAndWallsTileTheBuildingWithoutOverlap) {
  Box2 box;
  for (const Polygon& wall : world_.walls) {
    for (const Point2& corner : wall.outer) box.extend(corner);
  }
  int wrong = 0;
  for (double x = box.min.x() + 0.026; x < box.max.x(); x += 0.05) {
    for (double y = box.min.y() + 0.026; y < box.max.y(); y += 0.05) {
      if (covers_of(world_, {x, y}) != 1) ++wrong;
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST_P(World, EveryDoorTouchesItsTwoRoomsAndItsJambsTouchAWall) {
  const auto room = [&](const std::optional<RoomId>& id) {
    return *std::find_if(world_.rooms.begin(), world_.rooms.end(),
                         [&](const PlanRoom& candidate) { return candidate.id == id; });
  };
  for (const PlanDoor& door : world_.doors) {
    ASSERT_TRUE(door.room_a && door.room_b) << "door " << door.id;
    const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
    const Point2 along = (door.jambs.b - door.jambs.a).normalized();
    const Point2 across(-along.y(), along.x());
    const Point2 left = middle + 0.15 * across;  // the walls are 0.2 m thick
    const Point2 right = middle - 0.15 * across;
    EXPECT_TRUE(contains(door.opening, middle)) << "door " << door.id;
    EXPECT_TRUE((contains(room(door.room_a), left) && contains(room(door.room_b), right)) ||
                (contains(room(door.room_a), right) && contains(room(door.room_b), left)))
        << "door " << door.id;
    EXPECT_NEAR((door.jambs.b - door.jambs.a).norm(), door.width_m, 1e-6);
    for (const Point2& behind_jamb :
         {Point2(door.jambs.a - 0.01 * along), Point2(door.jambs.b + 0.01 * along)}) {
      EXPECT_TRUE(std::any_of(world_.walls.begin(), world_.walls.end(),
                              [&](const Polygon& wall) { return contains(wall, behind_jamb); }))
          << "door " << door.id;
    }
  }
}

TEST_P(World, SizesAndLabelsBelongToTheirRooms) {
  for (const PlanRoom& room : world_.rooms) {
    double area_m2 = 0.0;
    for (const Polygon& part : room.parts) area_m2 += area(part);
    EXPECT_NEAR(room.area_m2, area_m2, 0.001) << room.name;
    EXPECT_TRUE(contains(room, room.label_point)) << room.name;
  }
}

TEST_P(World, FurnitureStandsInRooms) {
  for (const Polygon& piece : outlines_of(world_.furniture)) {
    const Point2 middle = interior_point(piece);
    EXPECT_EQ(std::count_if(world_.rooms.begin(), world_.rooms.end(),
                            [&](const PlanRoom& room) { return contains(room, middle); }),
              1);
  }
}

TEST_P(World, TheDriveStartsAtItsFirstWayPointEntersEveryRoomAndReturns) {
  const std::vector<Pose2> path = true_path(world_, drive_);
  EXPECT_EQ(path.front().position(), drive_.front());
  EXPECT_LT((path.back().position() - path.front().position()).norm(), 1.0);
  for (const PlanRoom& room : world_.rooms) {
    EXPECT_GT(std::count_if(path.begin(), path.end(),
                            [&](const Pose2& pose) { return contains(room, pose.position()); }),
              100)
        << room.name;
  }
}

TEST_P(World, TheDriveCrossesEveryDoorInTheMiddleAndStraight) {
  std::map<std::int64_t, int> crossings;
  for (std::size_t i = 1; i < drive_.size(); ++i) {
    const Segment2 leg{drive_[i - 1], drive_[i]};
    for (const PlanDoor& door : world_.doors) {
      const auto share = crossing_fraction(door.jambs, leg);
      if (!share) continue;
      ++crossings[door.id];
      EXPECT_NEAR(*share, 0.5, 0.02) << "door " << door.id;
      EXPECT_NEAR((leg.b - leg.a).normalized().dot((door.jambs.b - door.jambs.a).normalized()), 0.0,
                  1e-6);
      EXPECT_GE((leg.a - (door.jambs.a + door.jambs.b) / 2.0).norm(), 0.69);
      EXPECT_GE((leg.b - (door.jambs.a + door.jambs.b) / 2.0).norm(), 0.69);
    }
  }
  EXPECT_EQ(crossings.size(), world_.doors.size());
}

TEST(Worlds, EightRoomsHasEightRoomsTwoCorridorsAndADriveOfTheLengthItClaims) {
  const FloorPlan world = read_plan(test::kWorlds / "eight_rooms.geojson");
  const auto corridors =
      std::count_if(world.rooms.begin(), world.rooms.end(),
                    [](const PlanRoom& room) { return room.kind == RoomKind::corridor; });
  EXPECT_EQ(world.rooms.size(), 10U);
  EXPECT_EQ(corridors, 2);
  EXPECT_EQ(world.doors.size(), 13U);
  EXPECT_NEAR(length(drive_of("eight_rooms")), 223.0, 1.0);
}

}  // namespace
}  // namespace roomatlas
