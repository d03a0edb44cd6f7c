// SPDX-License-Identifier: GPL-3.0-or-later
// Returns, and walls against them, one by one.
#include "../../src/sonar/return_matches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <set>

#include "../../src/sonar/sonar_problem.hpp"
#include "roomatlas/odometry/drive_directions.hpp"
#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

/// Nodes, walls and returns anywhere in a hall of 12 m.
struct Hall {
  std::vector<Pose2> nodes;
  std::vector<SeenWall> walls;
  std::vector<SeenReturn> returns;
};

Hall random_hall() {
  std::mt19937 random(7);
  const auto between = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  Hall hall;
  for (std::size_t k = 0; k < 60; ++k) {
    hall.nodes.push_back({between(0.0, 12.0), between(0.0, 12.0), between(-kPi, kPi)});
    const double path_m = 0.4 * static_cast<double>(k);
    for (int i = 0; i < 5; ++i) {
      hall.walls.push_back({k,
                            between(-kPi, kPi),
                            {between(-3.0, 3.0), between(-3.0, 3.0)},
                            between(0.4, 2.5),
                            path_m});
      hall.returns.push_back({k,
                              {between(-0.2, 0.2), between(-0.2, 0.2), between(-kPi, kPi)},
                              between(0.3, 3.0),
                              radians(12.0),
                              path_m});
    }
  }
  return hall;
}

/// As the model of a cone has it: within 0.15 m of the range, where the wall was seen.
bool may_come_from(const SeenReturn& seen, const SeenWall& wall, const std::vector<Pose2>& nodes) {
  if (seen.node == wall.node || std::abs(seen.path_m - wall.path_m) < 1.0) return false;
  const Pose2 sonar = nodes[seen.node] * seen.node_from_sonar;
  const ConeReturn heard{sonar.position(), sonar.theta_rad, seen.range_m};
  const Point2 middle = nodes[wall.node] * wall.middle_node;
  ConeLine line{wrap_angle(nodes[wall.node].theta_rad + wall.normal_rad)};
  line.offset_m = line.normal.dot(middle);
  if (std::abs(wrap_angle(line.normal_rad - heard.axis_rad)) > 1.0) return false;
  const auto expected_m = range_to_line(heard, seen.half_cone_rad, line);
  if (!expected_m || std::abs(*expected_m - seen.range_m) > 0.15) return false;
  const double beside_m = (foot_of(heard, seen.half_cone_rad, line) - middle).norm();
  const double across_m = line.normal.dot(foot_of(heard, seen.half_cone_rad, line)) - line.offset_m;
  return std::sqrt(beside_m * beside_m - across_m * across_m) <= wall.length_m / 2.0 + 0.1;
}

/// The same mission with each sonar as a sensor of its own, as ROS has them.
std::vector<RangeReading> one_by_one(const std::vector<RangeReading>& readings) {
  const RangeSensor& ring = *readings.front().sensor;
  std::vector<std::shared_ptr<const RangeSensor>> sonars;
  for (const Pose2& beam : ring.robot_from_beam) {
    sonars.push_back(std::make_shared<const RangeSensor>(
        RangeSensor{ring.kind, {beam}, ring.half_cone_rad, ring.max_range_m}));
  }
  std::vector<RangeReading> result;
  for (const RangeReading& reading : readings) {
    for (std::size_t i = 0; i < sonars.size(); ++i) {
      result.push_back(
          {reading.timestamp_s, reading.odom_from_robot, sonars[i], {reading.ranges_m[i]}});
    }
  }
  return result;
}

std::vector<SeenReturn> returns_of(const std::vector<RangeReading>& readings) {
  const DriveDirections directions = find_drive_directions(readings, {});
  const DrivenPath path = driven_path(readings, directions, {});
  return seen_returns(readings, path,
                      sonar_problem(readings, path, path.odom_from_robot, {0.0}, {}));
}

TEST(SeenReturns, OfSonarsThatAreSensorsOfTheirOwnAreThoseOfTheRing) {
  const auto ring = returns_of(test::bent_corridor(30.0).readings);
  const auto alone = returns_of(one_by_one(test::bent_corridor(30.0).readings));
  ASSERT_EQ(alone.size(), ring.size());
  ASSERT_GT(ring.size(), 1000U);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    EXPECT_EQ(alone[i].node, ring[i].node);
    EXPECT_EQ(alone[i].range_m, ring[i].range_m);
    EXPECT_EQ(alone[i].share, ring[i].share);
    EXPECT_NEAR(alone[i].node_from_sonar.x_m, ring[i].node_from_sonar.x_m, 1e-9);
    EXPECT_NEAR(alone[i].node_from_sonar.theta_rad, ring[i].node_from_sonar.theta_rad, 1e-9);
  }
  EXPECT_EQ(ring.front().share, 1.0 / 8.0);
}

TEST(ReturnMatches, AreThoseOfAllPairsThreeOfAReturnAtMost) {
  const Hall hall = random_hall();
  std::map<std::uint32_t, std::set<std::uint32_t>> all;
  for (std::uint32_t i = 0; i < hall.returns.size(); ++i) {
    for (std::uint32_t k = 0; k < hall.walls.size(); ++k) {
      if (may_come_from(hall.returns[i], hall.walls[k], hall.nodes)) all[i].insert(k);
    }
  }
  std::map<std::uint32_t, std::set<std::uint32_t>> found;
  std::map<std::uint32_t, double> shares;
  for (const ReturnMatch& match : find_return_matches(hall.returns, hall.walls, hall.nodes)) {
    EXPECT_TRUE(all[match.heard].contains(match.wall));
    found[match.heard].insert(match.wall);
    shares[match.heard] += match.share;
  }
  std::erase_if(all, [](const auto& one) { return one.second.empty(); });
  ASSERT_EQ(found.size(), all.size());
  EXPECT_GT(all.size(), 50U);
  for (const auto& [heard, walls] : all) {
    EXPECT_EQ(found[heard].size(), std::min<std::size_t>(3, walls.size()));
    EXPECT_NEAR(shares[heard], 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace roomatlas
