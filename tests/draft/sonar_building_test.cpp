// SPDX-License-Identifier: GPL-3.0-or-later
// What sonars hear of furnished rooms: walls, doors and leaves told from furniture.
#include <gtest/gtest.h>

#include <algorithm>

#include "../../src/draft/driven_gaps.hpp"
#include "../../src/draft/sonar_walls.hpp"
#include "../../src/draft/wall_openings.hpp"
#include "known_poses.hpp"
#include "roomatlas/draft/draft_building.hpp"
#include "roomatlas/simulate/explore.hpp"

namespace roomatlas {
namespace {

/// A face that looks along `normal`, from one point to another.
WallFace face_between(const Point2& a, const Point2& b, const Point2& normal) {
  WallFace face;
  face.normal_rad = std::atan2(normal.y(), normal.x());
  face.offset_m = a.dot(face.normal());
  const double from_m = a.dot(face.along());
  const double to_m = b.dot(face.along());
  face.seen = {{std::min(from_m, to_m), std::max(from_m, to_m)}};
  face.is_regular = true;
  return face;
}

/// Two rooms of 4 m x 4 m, a wall at x = 4 with a door from y = 1.5 to 2.4 between them, and in the
/// left room a table whose sides lie on one line with a box, 0.9 m apart.
struct TwoRooms {
  Walls walls;
  Occupancy occupancy;

  TwoRooms() {
    const auto add = [&](Point2 a, Point2 b, Point2 normal) {
      walls.faces.push_back(face_between(a, b, normal));
      walls.faces.back().cover = walls.faces.back().seen;
    };
    add({0.0, 0.0}, {8.0, 0.0}, {0.0, 1.0});
    add({0.0, 4.0}, {8.0, 4.0}, {0.0, -1.0});
    add({0.0, 0.0}, {0.0, 4.0}, {1.0, 0.0});
    add({8.0, 0.0}, {8.0, 4.0}, {-1.0, 0.0});
    add({4.0, 0.0}, {4.0, 4.0}, {-1.0, 0.0});  // 4: with a door
    walls.faces.back().seen = {{-4.0, -2.4}, {-1.5, 0.0}};
    add({2.0, 0.8}, {2.0, 1.8}, {-1.0, 0.0});  // 5: a table's side, off all walls
    add({2.0, 2.7}, {2.0, 3.2}, {-1.0, 0.0});  // 6: a box on its line
    for (WallFace& face : walls.faces) face.prominence_m = face.support_m();
    walls.faces[4].cover = {{-4.0, 0.0}};
    occupancy.frame.cell_m = 0.05;
    const CellBox box{{-20, -20}, {180, 100}};
    for (CellMask* mask : {&occupancy.seen, &occupancy.free, &occupancy.obstacle}) {
      *mask = CellMask(box);
    }
    for_each_cell({{0, 0}, {160, 80}}, [&](const Cell& cell) { occupancy.free.set(cell, true); });
    for (const WallFace& face : walls.faces) {
      for (const Interval& one : face.seen) {
        for_each_cell_on_line(occupancy.frame.cell_of(face.at(one.low_m)),
                              occupancy.frame.cell_of(face.at(one.high_m)), [&](const Cell& cell) {
                                occupancy.free.set(cell, false);
                                occupancy.obstacle.set(cell, true);
                                return true;
                              });
      }
    }
  }
};

const Segment2 kDoor{{4.0, 1.5}, {4.0, 2.4}};

TEST(SonarWalls, RunFromWallToWallAndSidesOfTablesDoNot) {
  const TwoRooms rooms;
  const std::vector<bool> is_wall = sonar_walls(rooms.walls, rooms.occupancy, {});
  const std::vector<bool> expected = {true, true, true, true, true, false, false};
  EXPECT_EQ(is_wall, expected);
}

TEST(WallOpenings, AreInWallsAndNotBetweenFurniture) {
  const TwoRooms rooms;
  const std::vector<bool> is_wall = sonar_walls(rooms.walls, rooms.occupancy, {});
  const BuildingGrid nothing_heard{
      {0.1}, CellMask(CellBox{}), CellMask(CellBox{}), CellMask(CellBox{})};
  const WallOpenings judge(rooms.walls, is_wall, rooms.occupancy, nothing_heard);
  EXPECT_TRUE(judge.is_in_wall(kDoor));
  EXPECT_FALSE(judge.is_in_wall({{2.0, 1.8}, {2.0, 2.7}})) << "between the table and the box";
  EXPECT_FALSE(judge.is_in_wall({{2.0, 0.0}, {2.0, 0.8}})) << "between a wall and the table";
}

TEST(DrivenGaps, AreDoorsAndNothingStandsInTheirSwing) {
  TwoRooms rooms;
  const Segment2 leaf{{3.9, 1.5}, {3.0, 1.5}};
  rooms.walls.faces.push_back(face_between(leaf.a, leaf.b, {0.0, 1.0}));
  rooms.walls.faces.back().cover = rooms.walls.faces.back().seen;
  const std::vector<bool> is_wall = sonar_walls(rooms.walls, rooms.occupancy, {});
  const std::vector<Pose2> path = {{2.8, 2.0, 0.0}, {3.8, 2.0, 0.0}, {4.3, 1.9, 0.0}};
  const std::vector<Segment2> gaps = driven_gaps(rooms.walls, is_wall, path);
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_NEAR((gaps[0].b - gaps[0].a).norm(), 0.9, 1e-6);
  EXPECT_NEAR(((gaps[0].a + gaps[0].b) / 2.0 - Point2(4.0, 1.95)).norm(), 0.0, 1e-6);
  const std::vector<WallFace> left = without_swings(rooms.walls, is_wall, gaps);
  EXPECT_EQ(left.size(), rooms.walls.faces.size() - 1) << "the leaf alone is gone";
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_NEAR(left[i].support_m(), rooms.walls.faces[i].support_m(), 1e-9) << i;
  }
  EXPECT_TRUE(driven_gaps(rooms.walls, is_wall, {{1.0, 2.0, 0.0}, {3.0, 2.0, 0.0}}).empty());
}

/// A furnished world that the robot explores.
test::KnownMission explored(const std::string& name, std::uint64_t furnish_seed) {
  test::KnownMission mission{read_plan(test::kWorlds / (name + ".geojson")), {}, {}};
  const SimulationOptions robot;
  ExploreOptions options;
  options.world_from_start = default_start(mission.world, robot.footprint);
  FurnishOptions furniture;
  furniture.route = {options.world_from_start->position()};
  mission.world = furnished(std::move(mission.world), furnish_seed, furniture);
  Asr asr;
  asr.id = 1;
  (void)explore(mission.world, robot, options, [&](const SimulatedStep& step) {
    asr.path.push_back(
        {step.truth.timestamp_s, step.truth.world_from_robot, step.odometry.odom_from_robot});
    asr.readings.push_back(step.reading);
  });
  mission.store.put(asr);
  mission.evidence = gather_evidence(mission.store, {{1, Pose2{}}}, robot.footprint, {}, {});
  return mission;
}

void expect_rooms(const std::string& name, std::uint64_t furnish_seed, double area_share) {
  const test::KnownMission mission = explored(name, furnish_seed);
  const DraftedBuilding drafted = draft_building(mission.evidence, {});
  test::expect_rooms_of(mission.world, drafted, area_share);
  for (const PlanDoor& door : mission.world.doors) {
    const Point2 middle = (door.jambs.a + door.jambs.b) / 2.0;
    EXPECT_TRUE(std::any_of(drafted.doors.begin(), drafted.doors.end(), [&](const Door& one) {
      return (one.frame_from_pivot.position() - middle).norm() < 0.3;
    })) << door.id;
  }
}

TEST(FurnishedSonarBuilding, HasTheRoomsOfTheWorldWithoutItsFurniture) {
  expect_rooms("two_rooms", 3, 0.05);
}

TEST(FurnishedSonarBuilding, HasTheRoomsAndDoorsOfALargerWorld) {
  expect_rooms("eight_rooms", 2, 0.3);  // a corner behind desks is never heard
}

}  // namespace
}  // namespace roomatlas
