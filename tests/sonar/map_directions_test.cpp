// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/sonar/map_directions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {
namespace {

/// Walls of a drive; in turn along both axes of a direction.
struct DrivenWalls {
  std::vector<MapWall> walls;

  void along(double direction_deg, int count, double length_m, double scatter_deg) {
    for (int i = 0; i < count; ++i) {
      const double off_deg = scatter_deg * std::sin(2.4 * i);
      walls.push_back({radians(direction_deg + off_deg + 90.0 * (i % 4)), length_m});
    }
  }
  [[nodiscard]] std::vector<double> directions_deg() const {
    std::vector<double> result;
    for (const double rad : map_directions(walls)) result.push_back(degrees(rad));
    std::sort(result.begin(), result.end());
    return result;
  }
};

TEST(MapDirections, OfWingsAtSmallAnglesAreAllOfThem) {
  DrivenWalls drive;
  drive.along(3.0, 60, 1.0, 2.0);
  drive.along(8.5, 40, 1.5, 2.0);
  drive.along(14.0, 50, 1.2, 2.0);
  drive.along(3.0, 20, 1.0, 2.0);
  const auto found = drive.directions_deg();
  ASSERT_EQ(found.size(), 3U);
  EXPECT_NEAR(found[0], 3.0, 0.5);
  EXPECT_NEAR(found[1], 8.5, 0.5);
  EXPECT_NEAR(found[2], 14.0, 0.5);
}

TEST(MapDirections, AreFollowedByTheShareOfTheWallsThatLieNear) {
  DrivenWalls drive;
  drive.along(3.0, 30, 2.0, 2.0);   // near, and no more than a metre counts
  drive.along(20.0, 20, 0.5, 0.0);  // 17 degrees off
  const std::vector<double> one_rad = {radians(3.0)};
  EXPECT_NEAR(followed_share(drive.walls, one_rad), 30.0 / 40.0, 1e-12);
  const std::vector<double> both_rad = {radians(3.0), radians(20.0)};
  EXPECT_NEAR(followed_share(drive.walls, both_rad), 1.0, 1e-12);
}

TEST(MapDirections, CountModuloARightAngle) {
  DrivenWalls drive;
  drive.along(44.5, 60, 1.3, 2.0);  // at the seam
  drive.along(100.0, 60, 0.7, 3.0);
  const auto found = drive.directions_deg();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0], 10.0, 0.6);
  EXPECT_NEAR(found[1], 44.5, 0.6);
}

TEST(MapDirections, OfWallsThatScatterAboutOneAreOne) {
  DrivenWalls drive;
  drive.along(5.0, 200, 1.0, 4.0);
  for (std::size_t i = 10; i < drive.walls.size(); i += 20) {
    drive.walls[i].normal_rad += radians(20.0);  // furniture here and there
  }
  const auto found = drive.directions_deg();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0], 5.0, 0.7);
  EXPECT_TRUE(map_directions({}).empty());
}

/// What the course of directions costs, as the definition has it.
double cost_of(const std::vector<MapWall>& walls, const std::vector<double>& directions_rad,
               const std::vector<std::size_t>& followed, const MapDirectionsOptions& options) {
  double cost = 0.0;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const double sigma =
        std::hypot(options.wall_sigma_rad, options.end_sigma_m / walls[i].length_m);
    const double sigmas =
        std::min(options.far_sigmas,
                 std::abs(wrap_quarter(walls[i].normal_rad - directions_rad[followed[i]])) / sigma);
    cost += options.share * std::min(1.0, walls[i].length_m) * sigmas * sigmas / 2.0;
    if (i > 0 && followed[i] != followed[i - 1]) cost += options.switch_cost;
  }
  return cost;
}

TEST(DirectionsFollowed, AreTheCheapestOfAllCourses) {
  const std::vector<double> directions_rad = {0.0, radians(6.0), radians(-20.0)};
  MapDirectionsOptions options;
  options.switch_cost = 0.4;  // so that eight walls change over
  for (int seed = 0; seed < 20; ++seed) {
    DrivenWalls drive;
    for (int i = 0; i < 8; ++i) {
      drive.along(14.0 * std::sin(0.9 * i + seed), 1, 0.5 + 0.2 * (i % 4), 0.0);
    }
    double least = std::numeric_limits<double>::max();
    for (std::size_t course = 0; course < 6561; ++course) {
      std::vector<std::size_t> followed;
      for (std::size_t rest = course; followed.size() < 8; rest /= 3) followed.push_back(rest % 3);
      least = std::min(least, cost_of(drive.walls, directions_rad, followed, options));
    }
    const auto found = directions_followed(drive.walls, directions_rad, options);
    EXPECT_NEAR(cost_of(drive.walls, directions_rad, found, options), least, 1e-9);
  }
}

TEST(DirectionsFollowed, AreAWingsThoughSingleWallsLieNearerToAnother) {
  DrivenWalls drive;
  drive.along(0.0, 30, 1.0, 3.0);
  drive.along(6.0, 30, 1.0, 3.5);
  const std::vector<double> directions_rad = {0.0, radians(6.0)};
  const auto found = directions_followed(drive.walls, directions_rad);
  for (std::size_t i = 0; i < 60; ++i) {
    if (i >= 27 && i <= 32) continue;
    EXPECT_EQ(found[i], i < 30 ? 0U : 1U) << i;
  }
}

}  // namespace
}  // namespace roomatlas
