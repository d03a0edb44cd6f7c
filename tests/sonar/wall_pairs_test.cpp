// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_pairs.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace roomatlas {
namespace {

/// A wall that a robot passes again and again, seen once each time.
struct Passed {
  std::vector<SeenWall> walls;
  std::vector<Pose2> map_from_node;
};

Passed passed(std::size_t times) {
  Passed result;
  for (std::size_t i = 0; i < times; ++i) {
    SeenWall wall;
    wall.node = i;
    wall.normal_rad = kPi / 2.0;
    wall.middle_node = {0.0, 1.0};
    wall.length_m = 2.0;
    wall.path_m = 5.0 * static_cast<double>(i);
    result.walls.push_back(wall);
    result.map_from_node.push_back({0.1 * static_cast<double>(i % 7), 0.0, 0.0});
  }
  return result;
}

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

Pairs pairs_of(const Passed& mission, std::size_t most_later) {
  WallPairOptions options;
  options.most_later = most_later;
  Pairs pairs;
  for (const WallPair& pair : find_wall_pairs(mission.walls, mission.map_from_node, 0.5, options)) {
    EXPECT_TRUE(pairs.insert({pair.first, pair.second}).second);
  }
  return pairs;
}

TEST(WallPairs, OfAWallThatIsPassedAgainAndAgainGrowWithThePasses) {
  const Passed mission = passed(100);
  const Pairs all = pairs_of(mission, 1000);
  EXPECT_EQ(all.size(), 100U * 99U / 2U);
  const Pairs some = pairs_of(mission, 8);
  EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
  std::map<std::size_t, std::set<std::size_t>> later;
  for (const auto& [first, second] : some) later[first].insert(second);
  for (const auto& [first, seconds] : later) {
    EXPECT_EQ(seconds.size(), std::min<std::size_t>(8, 99 - first));
    if (first >= 50) continue;
    EXPECT_GT(*seconds.rbegin() - *seconds.begin(), (99 - first) / 2);  // all over
  }
}

}  // namespace
}  // namespace roomatlas
