// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/loops/wider_matches.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace roomatlas {
namespace {

/// A room at `was` that the match would move as `building_moved` moves the whole building.
WiderMatch moving(const Pose2& was, const Pose2& building_moved, int gain) {
  WiderMatch wider;
  wider.building_from_was = was;
  wider.building_from_is = building_moved * was;
  wider.gain = gain;
  return wider;
}

TEST(TakeMostAlike, TakesWhatMovesAsAWhole) {
  const Pose2 lost{2.0, -1.0, radians(8.0)};
  std::vector<WiderMatch> found;
  for (int i = 0; i < 5; ++i) {
    const Pose2 a_little_off{0.1 * std::sin(i), 0.1 * std::cos(i), radians(0.3 * std::sin(i))};
    found.push_back(moving({4.0 * i, 7.0, 0.4 * i}, lost * a_little_off, 100));
    found.push_back(moving({4.0 * i, 1.0, 0.0}, {1.5 * i - 4.0, 3.0, radians(5.0 * i)}, 130));
  }
  const std::vector<WiderMatch> taken = take_most_alike(found);
  EXPECT_EQ(taken.size(), 5U);
  for (const WiderMatch& wider : taken) EXPECT_EQ(wider.gain, 100);
  EXPECT_EQ(found.size(), 5U);
  for (const WiderMatch& wider : found) EXPECT_EQ(wider.gain, 130);
}

TEST(TakeMostAlike, TakesOneByOneWhereNoTwoAgree) {
  std::vector<WiderMatch> found = {moving({}, {3.0, 0.0, 0.0}, 50), moving({}, {0.0, 3.0, 0.0}, 70),
                                   moving({}, {0.0, 0.0, radians(20.0)}, 60)};
  EXPECT_EQ(take_most_alike(found).front().gain, 70);
  EXPECT_EQ(take_most_alike(found).front().gain, 60);
  EXPECT_EQ(take_most_alike(found).front().gain, 50);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace roomatlas
