// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/simulate/explore.hpp"
#include "simulate/furnished_world.hpp"

namespace roomatlas::testing_simulate {
namespace {

SimulationOptions with_people(int people) {
  SimulationOptions options = exact();
  options.sensor = SensorKind::laser;
  options.laser = {0.0, 0.0};
  options.people = people;
  return options;
}

/// Through all doors of `offices` and back.
Drive rounds() {
  return {{2.45, 3.0},  {2.45, 6.85}, {5.05, 6.85}, {5.05, 11.0}, {9.0, 11.0},
          {5.05, 11.0}, {5.05, 6.85}, {7.45, 6.85}, {7.45, 3.0},  {7.45, 1.15},
          {2.45, 1.15}, {2.45, 6.85}, {5.05, 6.85}, {5.05, 11.0}};
}

/// From the robot's rectangle to a place.
double distance_to_robot(const Pose2& world_from_robot, const Point2& at) {
  const RobotFootprint footprint;
  const Point2 half(footprint.length_m / 2.0, footprint.width_m / 2.0);
  const Point2 out = (inverse(world_from_robot) * at).cwiseAbs() - half;
  return out.cwiseMax(0.0).norm();
}

TEST(People, NeverTouchTheRobot) {
  double nearest_m = 10.0;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    SimulationOptions options = with_people(12);  // crowded: it meets them in doors and corridor
    options.seed = seed;
    for (const SimulatedStep& step : run(offices(), rounds(), options)) {
      for (const Point2& at : step.people) {
        nearest_m = std::min(nearest_m, distance_to_robot(step.truth.world_from_robot, at));
      }
    }
  }
  EXPECT_GE(nearest_m, kPersonRadius_m);
  EXPECT_LT(nearest_m, 0.6);  // they do meet
}

TEST(People, WalkThroughTheBuildingAtPeoplesSpeedAndOffWalls) {
  const FloorPlan world = offices();
  const auto steps = run(world, rounds(), with_people(4));
  double walked_m = 0.0;
  std::set<RoomId> entered;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    ASSERT_LE(steps[i].people.size(), 4U);
    for (const Point2& at : steps[i].people) {
      EXPECT_GE(clearance_m(world.walls, at), kPersonRadius_m);
      for (const PlanRoom& room : world.rooms) {
        if (is_in_any(room.parts, at)) entered.insert(room.id);
      }
    }
    if (steps[i].people.size() != steps[i - 1].people.size()) continue;
    for (std::size_t person = 0; person < steps[i].people.size(); ++person) {
      const double step_m = (steps[i].people[person] - steps[i - 1].people[person]).norm();
      if (step_m > 2.0) continue;  // gone, and back elsewhere
      EXPECT_LE(step_m, 0.12 + 1e-9);
      walked_m += step_m;
    }
  }
  EXPECT_GT(walked_m, 20.0);
  EXPECT_EQ(entered.size(), 4U);
}

/// Where a ray meets a circle, by its equation; nothing where it passes.
std::optional<double> hit_m(const Point2& from, const Point2& along, const Point2& middle,
                            double radius_m) {
  const double ahead_m = (middle - from).dot(along);
  const double aside_m = std::abs(cross(along, middle - from));
  if (ahead_m <= 0.0 || aside_m >= radius_m) return std::nullopt;
  return ahead_m - std::sqrt(radius_m * radius_m - aside_m * aside_m);
}

TEST(People, AreHitByRays) {
  const auto with = run(offices(), rounds(), with_people(6));
  const auto without = run(offices(), rounds(), with_people(0));
  ASSERT_EQ(with.size(), without.size());
  std::size_t hits = 0;
  for (std::size_t i = 0; i < with.size(); i += 5) {
    const RangeReading& reading = with[i].reading;
    for (std::size_t beam = 0; beam < reading.ranges_m.size(); beam += 7) {
      const Pose2 at = with[i].truth.world_from_robot * reading.sensor->robot_from_beam[beam];
      double circle_m = without[i].reading.ranges_m[beam];
      double inner_m = circle_m;  // of the twelve edges' inscribed circle
      for (const Point2& person : with[i].people) {
        const Point2 along = direction(at.theta_rad);
        circle_m = std::min(circle_m, hit_m(at.position(), along, person, 0.2).value_or(circle_m));
        inner_m = std::min(
            inner_m,
            hit_m(at.position(), along, person, 0.2 * std::cos(kPi / 12.0)).value_or(inner_m));
      }
      EXPECT_GE(reading.ranges_m[beam], circle_m - 1e-5);
      EXPECT_LE(reading.ranges_m[beam], inner_m + 1e-5);
      if (inner_m < without[i].reading.ranges_m[beam] - 0.1) ++hits;
    }
  }
  EXPECT_GT(hits, 100U);
}

TEST(People, TheSameSeedGivesTheSameWalksAndTheRobotsOdometryIsNotDisturbed) {
  SimulationOptions options = with_people(5);
  options.odometry = odometry_errors(OdometryPreset::typical);
  const auto first = run(offices(), rounds(), options);
  const auto second = run(offices(), rounds(), options);
  options.people = 0;
  const auto alone = run(offices(), rounds(), options);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i].people, second[i].people);
    ASSERT_EQ(first[i].reading.ranges_m, second[i].reading.ranges_m);
    ASSERT_EQ(first[i].odometry.odom_from_robot.position(),
              alone[i].odometry.odom_from_robot.position());
    EXPECT_TRUE(alone[i].people.empty());
  }
}

TEST(People, AnExplorerGetsThroughThem) {
  SimulationOptions options = with_people(3);
  ExploreOptions explore_options;
  explore_options.max_time_s = 3600.0;
  double nearest_m = 10.0;
  const ExploreSummary summary =
      explore(offices(), options, explore_options, [&](const SimulatedStep& step) {
        for (const Point2& at : step.people) {
          nearest_m = std::min(nearest_m, distance_to_robot(step.truth.world_from_robot, at));
        }
      });
  EXPECT_EQ(summary.entered.size(), 4U);
  EXPECT_EQ(summary.collisions, 0);
  EXPECT_GE(nearest_m, kPersonRadius_m);
}

TEST(People, FewerAppearWhereThereIsNoPlaceForThem) {
  SimulationOptions options = with_people(3);
  const auto steps = run(square_room(), {{2, 2}, {2.2, 2}}, options);  // nowhere 3 m away
  for (const SimulatedStep& step : steps) EXPECT_TRUE(step.people.empty());
  options.people = -1;
  EXPECT_THROW((void)run(square_room(), {{2, 2}, {2.2, 2}}, options), UsageError);
}

}  // namespace
}  // namespace roomatlas::testing_simulate
