// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/explore.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/simulate/world.hpp"

#include "simulate/simulated.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomatlas {
namespace {

using namespace testing_simulate;

Polygon slab(double min_x, double min_y, double max_x, double max_y) {
  return {box(min_x, min_y, max_x, max_y), {}};
}

PlanRoom room(RoomId id, double min_x, double min_y, double max_x, double max_y) {
  PlanRoom room;
  room.id = id;
  room.parts = {slab(min_x, min_y, max_x, max_y)};
  room.area_m2 = area(room.parts[0]);
  room.label_point = {(min_x + max_x) / 2.0, (min_y + max_y) / 2.0};
  return room;
}

/// Two rooms of 4 m x 4 m beside each other; the wall between them has a gap of 0.9 m.
FloorPlan two_rooms(bool with_door = true) {
  FloorPlan world;
  world.rooms = {room(1, 0, 0, 4, 4), room(2, 4.2, 0, 8.2, 4)};
  world.walls = {slab(-0.2, -0.2, 8.4, 0), slab(-0.2, 4, 8.4, 4.2), slab(-0.2, 0, 0, 4),
                 slab(8.2, 0, 8.4, 4)};
  if (with_door) {
    world.walls.push_back(slab(4, 0, 4.2, 1.5));
    world.walls.push_back(slab(4, 2.4, 4.2, 4));
  } else {
    world.walls.push_back(slab(4, 0, 4.2, 4));
  }
  return world;
}

ExploreSummary explored(const FloorPlan& world, const SimulationOptions& simulation,
                        const ExploreOptions& options = {}) {
  return explore(world, simulation, options, [](const SimulatedStep&) {});
}

TEST(Explore, EntersTheRoomBehindTheDoorAndEndsByItself) {
  for (const SensorKind sensor : {SensorKind::sonar, SensorKind::laser}) {
    SimulationOptions simulation;
    simulation.sensor = sensor;
    const ExploreSummary summary = explored(two_rooms(), simulation);
    EXPECT_TRUE(summary.finished);
    EXPECT_EQ(summary.collisions, 0);
    EXPECT_EQ(summary.entered, (std::set<RoomId>{1, 2}));
  }
}

TEST(Explore, LeavesAClosedOffRoomAloneAndEnds) {
  const ExploreSummary summary = explored(two_rooms(false), {});
  EXPECT_TRUE(summary.finished);
  EXPECT_EQ(summary.entered, (std::set<RoomId>{1}));
}

TEST(Explore, EndsWhenTheTimeIsUp) {
  ExploreOptions options;
  options.max_time_s = 5.0;
  const ExploreSummary summary = explored(two_rooms(), {}, options);
  EXPECT_FALSE(summary.finished);
  EXPECT_NEAR(summary.duration_s, 5.0, 0.11);
}

TEST(DefaultStart, IsFoundBesideATableThatFillsTheMiddles) {
  FloorPlan world = two_rooms();
  for (const double x : {2.0, 6.2}) {  // both rooms are free along their walls alone
    world.furniture.push_back({slab(x - 1.2, 0.8, x + 1.2, 3.2), FurnitureKind::free_standing});
  }
  const RobotFootprint robot;
  const double needed_m = std::hypot(robot.length_m, robot.width_m) / 2.0;
  const Point2 start = default_start(world, robot).position();
  EXPECT_NO_THROW(require_free(world, start, needed_m));
  // brute force over room 1: nothing there has clearly more room around it
  double best_m = 0.0;
  for (double x = 0.0; x < 4.0; x += 0.05) {
    for (double y = 0.0; y < 4.0; y += 0.05) {
      best_m = std::max(best_m, clearance_m(world, {x, y}));
    }
  }
  EXPECT_GT(clearance_m(world, start), best_m - 0.15);
}

TEST(DefaultStart, IsRefusedWhereNothingTellsInsideFromOutside) {
  FloorPlan world = two_rooms();
  world.rooms.clear();
  world.doors.clear();
  try {
    (void)default_start(world, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("--start X,Y,DEG"));
  }
}

TEST(Explore, EndsInAPlaceTooTightToTurnIn) {
  FloorPlan world;
  world.walls = {{box(-1, -1, 1.46, 1.42), {box(0, 0, 0.47, 0.42)}}};
  ExploreOptions options;
  options.world_from_start = Pose2{0.235, 0.21, 0.0};
  const ExploreSummary summary = explored(world, {}, options);
  EXPECT_LT(summary.duration_s, 600.0);
}

TEST(Explore, RefusesAStartInAWall) {
  ExploreOptions options;
  options.world_from_start = Pose2{4.1, 1.0, 0.0};
  EXPECT_THROW((void)explored(two_rooms(), {}, options), InputError);
}

TEST(Explore, RefusesAWorldWithoutAPlaceToStart) {
  FloorPlan world;
  world.walls = {slab(0, 0, 1, 1)};
  EXPECT_THROW((void)explored(world, {}), InputError);
}

TEST(Explore, TheSameSeedGivesTheSameMission) {
  const auto run = [](std::uint64_t seed) {
    SimulationOptions simulation;
    simulation.seed = seed;
    std::vector<SimulatedStep> steps;
    (void)explore(two_rooms(), simulation, {},
                  [&](const SimulatedStep& step) { steps.push_back(step); });
    return steps;
  };
  const auto same = [](const SimulatedStep& a, const SimulatedStep& b) {
    return a.odometry.odom_from_robot == b.odometry.odom_from_robot &&
           a.truth.world_from_robot == b.truth.world_from_robot &&
           a.reading.ranges_m == b.reading.ranges_m;
  };
  const auto first = run(3);
  const auto second = run(3);
  const auto other = run(4);
  ASSERT_EQ(first.size(), second.size());
  EXPECT_TRUE(std::equal(first.begin(), first.end(), second.begin(), same));
  EXPECT_FALSE(std::equal(first.begin(), first.end(), other.begin(), other.end(), same));
}

TEST(Explore, OdometryErrorsDoNotChangeTheDriveUnlessItBelievesThem) {
  const auto path_of = [](OdometryPreset preset, bool on_odometry) {
    SimulationOptions simulation;
    simulation.odometry = odometry_errors(preset);
    ExploreOptions options;
    options.on_odometry = on_odometry;
    options.max_time_s = 60.0;
    std::vector<Pose2> path;
    (void)explore(two_rooms(), simulation, options,
                  [&](const SimulatedStep& step) { path.push_back(step.truth.world_from_robot); });
    return path;
  };
  EXPECT_EQ(path_of(OdometryPreset::mild, false), path_of(OdometryPreset::hard, false));
  EXPECT_NE(path_of(OdometryPreset::mild, true), path_of(OdometryPreset::hard, true));
}

TEST(Explore, OnOdometryItComesToAnEndCountsContactsAndRepeatsItself) {
  SimulationOptions simulation;
  simulation.odometry = odometry_errors(OdometryPreset::hard);
  ExploreOptions options;
  options.on_odometry = true;
  options.max_time_s = 1200.0;
  const auto run = [&] {
    std::vector<Pose2> path;
    const ExploreSummary summary =
        explore(two_rooms(), simulation, options,
                [&](const SimulatedStep& step) { path.push_back(step.truth.world_from_robot); });
    // The second route to the contacts: a robot that touches something stands still for a period,
    // and it never stands in a wall.
    for (const Pose2& pose : path) {
      for (const Polygon& wall : two_rooms().walls) EXPECT_FALSE(contains(wall, pose.position()));
    }
    return std::pair{summary, path};
  };
  const auto [summary, path] = run();
  EXPECT_LE(summary.duration_s, options.max_time_s + 0.11);
  EXPECT_TRUE(summary.entered.contains(1));
  EXPECT_GE(summary.collisions, 0);
  std::int64_t standstills = 0;
  for (std::size_t i = 1; i < path.size(); ++i) standstills += path[i] == path[i - 1] ? 1 : 0;
  EXPECT_LE(summary.collisions, standstills);

  const auto [again, same_path] = run();
  EXPECT_EQ(again.collisions, summary.collisions);
  EXPECT_EQ(again.duration_s, summary.duration_s);
  EXPECT_EQ(same_path, path);
}

}  // namespace
}  // namespace roomatlas
