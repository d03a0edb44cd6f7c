// SPDX-License-Identifier: GPL-3.0-or-later
// Returns and walls against each other, one by one.
#include "../../src/sonar/return_matches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "roomatlas/sonar/wall_segments.hpp"

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
