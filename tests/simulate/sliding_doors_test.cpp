// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "roomatlas/core/issue.hpp"
#include "simulate/simulated.hpp"

namespace roomatlas {
namespace {

using namespace testing_simulate;

/// A wall along x = 6 with a door of 1 m about y = 2, and a wall 2 m behind it.
FloorPlan wall_with_a_door() {
  FloorPlan world;
  world.walls = {{box(6, -5, 6.2, 1.5), {}}, {box(6, 2.5, 6.2, 9), {}}, {box(8, -5, 8.2, 9), {}}};
  PlanDoor door;
  door.jambs = {{6.1, 1.5}, {6.1, 2.5}};
  door.width_m = 1.0;
  world.doors = {door};
  return world;
}

/// What the beam straight ahead measures on a slow way towards the door, from 0 on.
std::vector<SimulatedStep> towards_the_door(double share, double to_x) {
  SimulationOptions options = exact();
  options.sensor = SensorKind::laser;
  options.laser = {0.0, 0.0};
  options.speed_m_per_s = 0.01;
  options.moving_doors_share = share;
  return run(wall_with_a_door(), {{0, 2}, {to_x, 2}}, options);
}

double wall_seen_at_m(const SimulatedStep& step) {
  const auto ahead = static_cast<double>(step.reading.ranges_m[90]);
  return step.truth.world_from_robot.x_m + 0.1 + ahead;
}

TEST(SlidingDoors, OfNoShareStayOpen) {
  for (const SimulatedStep& step : towards_the_door(0.0, 3.0)) {
    EXPECT_NEAR(wall_seen_at_m(step), 8.0, 1e-4);
  }
}

TEST(SlidingDoors, AreSeenShutAndOpenFromAfar) {
  int shut = 0;
  int open = 0;
  for (const SimulatedStep& step : towards_the_door(1.0, 3.0)) {
    const double at_m = wall_seen_at_m(step);
    const bool is_shut = std::abs(at_m - 6.1) < 1e-4;
    EXPECT_TRUE(is_shut || std::abs(at_m - 8.0) < 1e-4) << at_m;
    ++(is_shut ? shut : open);
  }
  EXPECT_GT(shut, 300);
  EXPECT_GT(open, 300);
}

TEST(SlidingDoors, AreOpenWhereTheRobotComesNear) {
  for (const SimulatedStep& step : towards_the_door(1.0, 7.0)) {
    if (step.truth.world_from_robot.x_m < 4.0) continue;
    EXPECT_NEAR(wall_seen_at_m(step), 8.0, 1e-4);
  }
}

TEST(SlidingDoors, ThatHaveALeafAlreadyKeepIt) {
  FloorPlan world = wall_with_a_door();
  world.doors.front().leaf = Segment2{{6.1, 1.5}, {5.3, 1.5}};
  SimulationOptions options = exact();
  options.sensor = SensorKind::laser;
  options.laser = {0.0, 0.0};
  options.speed_m_per_s = 0.02;
  const auto still = run(world, {{0, 2}, {2, 2}}, options);
  options.moving_doors_share = 1.0;
  const auto moving = run(world, {{0, 2}, {2, 2}}, options);
  for (std::size_t i = 0; i < still.size(); ++i) {
    EXPECT_EQ(still[i].reading.ranges_m, moving[i].reading.ranges_m);
  }
}

TEST(SlidingDoors, ShareOutOfItsRangeIsRefused) {
  EXPECT_THROW((void)towards_the_door(1.5, 1.0), UsageError);
}

}  // namespace
}  // namespace roomatlas
