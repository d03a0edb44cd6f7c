// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/sonar/map_directions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace roomatlas {
namespace {

/// Walls heard from one pose each; in turn along both axes of a direction.
struct Map {
  std::vector<WallSegment> segments;
  std::vector<Pose2> map_from_robot;

  void add(double direction_deg, int count, double length_m, double scatter_deg) {
    for (int i = 0; i < count; ++i) {
      const double off_deg = scatter_deg * std::sin(2.4 * i);
      const double heading_rad = radians(37.0 * i);  // of the robot: must not matter
      WallSegment segment;
      segment.reading = map_from_robot.size();
      segment.length_m = length_m;
      segment.normal_rad =
          wrap_angle(radians(direction_deg + off_deg + 90.0 * (i % 4)) - heading_rad);
      segments.push_back(segment);
      map_from_robot.push_back({0.0, 0.0, wrap_angle(heading_rad)});
    }
  }
  [[nodiscard]] std::vector<double> directions_deg() const {
    std::vector<double> result;
    for (const double rad : map_directions(segments, map_from_robot, {})) {
      result.push_back(degrees(rad));
    }
    return result;
  }
  /// The density at a direction from its definition: a sum over all walls, without bins.
  [[nodiscard]] double density(double at_rad) const {
    double sum = 0.0;
    for (const WallSegment& segment : segments) {
      const double off_rad =
          wrap_quarter(map_from_robot[segment.reading].theta_rad + segment.normal_rad - at_rad);
      const double sigmas = off_rad / MapDirectionsOptions{}.blur_rad;
      sum += segment.length_m * std::exp(-sigmas * sigmas / 2.0);
    }
    return sum;
  }
};

TEST(MapDirections, AreThoseOfTheMostMetresOfWallFirst) {
  Map map;
  map.add(21.5, 60, 1.0, 3.0);
  map.add(-13.0, 40, 2.0, 3.0);  // fewer, but longer
  map.add(40.0, 3, 1.0, 1.0);    // furniture
  const auto found = map.directions_deg();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0], -13.0, 0.6);
  EXPECT_NEAR(found[1], 21.5, 0.6);
}

TEST(MapDirections, AreWhereTheSumOverAllWallsIsHighest) {
  Map map;
  map.add(44.0, 50, 1.3, 2.0);  // at the seam, modulo 90 degrees
  map.add(9.0, 31, 0.7, 3.0);
  const auto found = map_directions(map.segments, map.map_from_robot, {});
  ASSERT_EQ(found.size(), 2U);
  for (const double at_rad : found) {
    double highest_rad = at_rad;
    for (double off_deg = -5.0; off_deg <= 5.0; off_deg += 0.05) {
      if (map.density(at_rad + radians(off_deg)) > map.density(highest_rad)) {
        highest_rad = at_rad + radians(off_deg);
      }
    }
    EXPECT_NEAR(degrees(wrap_quarter(highest_rad - at_rad)), 0.0, 0.4);
  }
  EXPECT_GT(map.density(found[0]), map.density(found[1]));
}

TEST(MapDirections, OfWallsThatScatterAboutOneAreOne) {
  Map map;
  map.add(5.0, 200, 1.0, 4.0);
  EXPECT_EQ(map.directions_deg().size(), 1U);
  EXPECT_TRUE(map_directions({}, {}, {}).empty());
}

}  // namespace
}  // namespace roomatlas
