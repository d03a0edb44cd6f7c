// SPDX-License-Identifier: GPL-3.0-or-later
// Maps whose walls follow no direction, against the true poses of small worlds.
#include "../../src/sonar/free_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

constexpr double kDriftDegPerM = 2.0;

std::vector<Point2> ring(std::size_t corners, double radius_m) {
  std::vector<Point2> points;
  for (std::size_t k = 0; k < corners; ++k) {
    const double at_rad = 2.0 * kPi * static_cast<double>(k) / static_cast<double>(corners);
    points.emplace_back(radius_m * direction(at_rad));
  }
  return points;
}

/// Three times round a corridor of seven sides, which no three directions describe.
test::DrivenWorld seven_sides() {
  constexpr std::size_t kSides = 7;
  auto walls = test::walls_along(ring(kSides, 7.5), true);
  const auto inner = test::walls_along(ring(kSides, 5.0), true);
  walls.insert(walls.end(), inner.begin(), inner.end());
  const std::vector<Point2> middle = ring(kSides, 6.2);
  std::vector<Point2> way;
  for (std::size_t k = 0; k <= 3 * kSides; ++k) way.push_back(middle[k % kSides]);
  return test::drive(walls, way, kDriftDegPerM);
}

/// The largest error of a heading, both trajectories from their first pose on.
double largest_turn_deg(const std::vector<Pose2>& truth, const std::vector<Pose2>& found) {
  double largest_rad = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double off_rad =
        (found[i].theta_rad - found[0].theta_rad) - (truth[i].theta_rad - truth[0].theta_rad);
    largest_rad = std::max(largest_rad, std::abs(wrap_angle(off_rad)));
  }
  return degrees(largest_rad);
}

/// A drive, and what it takes to solve it without any direction of a wall.
struct FreeMission {
  test::DrivenWorld world = seven_sides();
  DriveDirections directions = find_drive_directions(world.readings, {});
  SonarTrajectoryOptions options;
  std::function<void()> nothing_before;
  SonarMission mission{world.readings, directions, options, nothing_before};
};

TEST(FreeMap, GrownFromTheBeginningNeedsNeitherDirectionsNorHabits) {
  const FreeMission free;
  const Idea grown_idea = grown(free.mission, {});
  ASSERT_EQ(grown_idea.attempt.map_from_robot.size(), free.world.truth.size());
  EXPECT_LT(largest_turn_deg(free.world.truth, grown_idea.attempt.map_from_robot), 4.0);
  EXPECT_NEAR(degrees(grown_idea.habits.bias_rad_per_m), -kDriftDegPerM, 0.3);
  EXPECT_TRUE(grown_idea.is_free);

  Idea at_once = idea_of(free.mission, {}, {0.0});
  std::fill(at_once.heading.correction_rad.begin(), at_once.heading.correction_rad.end(), 0.0);
  const Idea lost = loosened(free.mission, at_once);
  EXPECT_GT(largest_turn_deg(free.world.truth, lost.attempt.map_from_robot), 20.0);
  EXPECT_GT(merit(grown_idea.attempt), merit(lost.attempt));
}

TEST(FreeMap, GrowsWithoutHabitsWhereTheyAreTakenToBeNone) {
  FreeMission free;
  free.options.calibrate = false;
  const Idea idea = grown(free.mission, {});
  EXPECT_EQ(idea.habits, OdometryHabits{});
}

TEST(FreeMap, TellsManyDirectionsWhereMostWallsFollowNone) {
  const FreeMission free;
  Idea map = grown(free.mission, {});
  const std::vector<MapWall> walls = walls_on(map);
  ASSERT_FALSE(walls.empty());
  const std::vector<double> three_rad = map_directions(walls);
  ASSERT_EQ(three_rad.size(), 3U);
  map.followed_share = 1.0;
  EXPECT_EQ(directed(free.mission, map, three_rad).directions_rad.size(), 3U);
  map.followed_share = followed_share(walls, three_rad);
  EXPECT_LT(map.followed_share, 0.5);
  const Idea many = directed(free.mission, map, three_rad);
  EXPECT_EQ(many.directions_rad.size(), 7U);
  EXPECT_LT(largest_turn_deg(free.world.truth, many.attempt.map_from_robot), 4.0);
}

TEST(FreeMap, OfADriveTooShortForAStretchIsTheWholeOfIt) {
  FreeMission free;
  for (const std::size_t count : {1U, 2U, 40U}) {
    const DriveDirections directions =
        find_drive_directions(std::span<const RangeReading>(free.world.readings).first(count), {});
    const SonarMission part{free.mission.readings.first(count), directions, free.options,
                            free.nothing_before};
    EXPECT_EQ(grown(part, {}).attempt.map_from_robot.size(), count);
  }
}

}  // namespace
}  // namespace roomatlas
