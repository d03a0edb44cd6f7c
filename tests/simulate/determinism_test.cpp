// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/simulated.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace roomatlas {
namespace {

using namespace testing_simulate;

const Drive kAround = {{1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}};

SimulationOptions with_seed(std::uint64_t seed) {
  SimulationOptions options;
  options.seed = seed;
  return options;
}

bool same_odometry(const std::vector<SimulatedStep>& a, const std::vector<SimulatedStep>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.odometry.odom_from_robot == y.odometry.odom_from_robot;
  });
}

bool same_ranges(const std::vector<SimulatedStep>& a, const std::vector<SimulatedStep>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.reading.ranges_m == y.reading.ranges_m;
  });
}

TEST(Determinism, TheSameSeedGivesTheSameMission) {
  const auto first = run(square_room(), kAround, with_seed(7));
  const auto second = run(square_room(), kAround, with_seed(7));
  EXPECT_TRUE(same_odometry(first, second));
  EXPECT_TRUE(same_ranges(first, second));
}

TEST(Determinism, AnotherSeedGivesOtherErrorsOnTheSameTruth) {
  const auto first = run(square_room(), kAround, with_seed(1));
  const auto second = run(square_room(), kAround, with_seed(2));
  EXPECT_FALSE(same_odometry(first, second));
  EXPECT_FALSE(same_ranges(first, second));
  ASSERT_EQ(first.size(), second.size());
  EXPECT_EQ(first[100].truth.world_from_robot, second[100].truth.world_from_robot);
}

TEST(Determinism, WhatTheSonarsDoLeavesOdometryAsItIs) {
  SimulationOptions noisy = with_seed(1);
  noisy.sonar = {0.2, 0.5, 10.0, 0.3, 1.0};
  EXPECT_TRUE(
      same_odometry(run(square_room(), kAround, with_seed(1)), run(square_room(), kAround, noisy)));
}

TEST(Determinism, OdometryErrorsLeaveTheSonarsAsTheyAre) {
  SimulationOptions drifting = with_seed(1);
  drifting.odometry = {0.1, 1.0, 0.0, 0.1};
  EXPECT_TRUE(same_ranges(run(square_room(), kAround, with_seed(1)),
                          run(square_room(), kAround, drifting)));
}

}  // namespace
}  // namespace roomatlas
