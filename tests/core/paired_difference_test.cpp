// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/paired_difference.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <vector>

namespace roomatlas {
namespace {

/// Share of trials in which the first was preferred by more than chance, where each of its 40
/// pieces is better by so many standard deviations in the mean.
double share_decided(double better_sigmas) {
  constexpr int kTrials = 4000;
  constexpr int kPieces = 40;
  std::mt19937 random(7);
  std::normal_distribution<double> noise;
  int decided = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> first;
    std::vector<double> second;
    for (int i = 0; i < kPieces; ++i) {
      const double common = 10.0 * noise(random);  // alike for both: it must not count
      first.push_back(common + better_sigmas + noise(random));
      second.push_back(common);
    }
    if (!paired_difference(first, second).is_within_chance()) ++decided;
  }
  return static_cast<double>(decided) / kTrials;
}

TEST(PairedDifference, OfEqualExplanationsOneIsPreferredInFivePercent) {
  EXPECT_NEAR(share_decided(0.0), 0.05, 0.012);
}

TEST(PairedDifference, OneThatIsBetterNearlyEverywhereIsPreferred) {
  EXPECT_GT(share_decided(0.8), 0.99);
}

TEST(PairedDifference, OfNothingIsWithinChanceAndOfUnlikeCountsIsRefused) {
  EXPECT_TRUE(paired_difference({}, {}).is_within_chance());
  const std::vector<double> one{1.0};
  EXPECT_THROW((void)paired_difference(one, {}), std::invalid_argument);
}

}  // namespace
}  // namespace roomatlas
