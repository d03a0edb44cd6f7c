// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/tour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/simulate/furnish.hpp"
#include "simulate/furnished_world.hpp"

namespace roomatlas::testing_simulate {
namespace {

FloorPlan furnished_offices(std::uint64_t seed) {
  FurnishOptions options;
  options.route = {{2.5, 3.0}};
  return furnished(offices(), seed, options);
}

/// Points on the drive, 5 cm apart.
std::vector<Point2> points_on(const Drive& drive) {
  std::vector<Point2> points = {drive.front()};
  for (std::size_t i = 1; i < drive.size(); ++i) {
    const double length_m = (drive[i] - drive[i - 1]).norm();
    const int steps = static_cast<int>(std::ceil(length_m / 0.05));
    for (int step = 1; step <= steps; ++step) {
      points.push_back(drive[i - 1] +
                       static_cast<double>(step) / steps * (drive[i] - drive[i - 1]));
    }
  }
  return points;
}

TEST(Tour, LeadsThroughAllRoomsClearOfWhatStandsThere) {
  const RobotFootprint footprint;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const FloorPlan world = furnished_offices(seed);
    const Drive drive = tour(world, {2.5, 3.0}, {});
    const auto bodies = all_bodies(world);
    std::set<RoomId> entered;
    double nearest_m = 1.0;
    for (const Point2& at : points_on(drive)) {
      nearest_m = std::min(nearest_m, clearance_m(bodies, at));
      for (const PlanRoom& room : world.rooms) {
        if (is_in_any(room.parts, at)) entered.insert(room.id);
      }
    }
    EXPECT_EQ(entered.size(), world.rooms.size());
    EXPECT_GE(nearest_m, footprint.width_m / 2.0);
    SimulationOptions options = exact();
    options.speed_m_per_s = 5.0;                        // to be done soon
    EXPECT_GT(run(world, drive, options).size(), 10U);  // it is not refused
  }
}

TEST(Tour, PassesEveryPlaceThatTheRobotGetsToWithinTheView) {
  const FloorPlan world = furnished_offices(2);
  TourOptions options;
  options.view_m = 1.5;
  const std::vector<Point2> drive = points_on(tour(world, {2.5, 3.0}, options));
  const auto bodies = all_bodies(world);
  const Cells places =
      reached({2.5, 3.0}, [&](const Point2& at) { return clearance_m(bodies, at) >= 0.33; });
  ASSERT_GT(places.size(), 10000U);
  double farthest_m = 0.0;
  for (const auto& cell : places) {
    const Point2 at = place_of(cell);
    if (std::none_of(world.rooms.begin(), world.rooms.end(),
                     [&](const PlanRoom& room) { return is_in_any(room.parts, at); })) {
      continue;  // in a doorway
    }
    double nearest_m = 100.0;
    for (const Point2& on_drive : drive) nearest_m = std::min(nearest_m, (on_drive - at).norm());
    farthest_m = std::max(farthest_m, nearest_m);
  }
  EXPECT_LE(farthest_m, options.view_m + 0.36);  // places are looked at every 0.25 m
  EXPECT_GT(farthest_m, 0.5);
}

TEST(Tour, IsTheSameEachTime) {
  const FloorPlan world = furnished_offices(4);
  EXPECT_EQ(tour(world, {2.5, 3.0}, {}), tour(world, {2.5, 3.0}, {}));
}

TEST(Tour, LeavesOutARoomThatTheRobotDoesNotGetTo) {
  FloorPlan world = offices();
  world.walls.push_back({box(4.6, 7.5, 5.5, 7.7), {}});  // the hall's door is walled up
  for (const Point2& at : points_on(tour(world, {2.5, 3.0}, {}))) EXPECT_LT(at.y(), 7.5);
}

TEST(Tour, WithoutRoomsOrFromInsideAWallThereIsNone) {
  EXPECT_THROW((void)tour(square_room(), {2, 2}, {}), InputError);
  EXPECT_THROW((void)tour(offices(), {-5, -5}, {}), InputError);
}

}  // namespace
}  // namespace roomatlas::testing_simulate
