// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <set>

namespace roomatlas {
namespace {

double sum_of(const WeightTable& weights, const std::vector<std::optional<std::size_t>>& columns) {
  double sum = 0.0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i]) sum += weights[i][*columns[i]];
  }
  return sum;
}

/// The best sum by trying everything.
double best_sum(const WeightTable& weights, std::size_t row = 0, std::set<std::size_t> used = {}) {
  if (row == weights.size()) return 0.0;
  double best = best_sum(weights, row + 1, used);
  for (std::size_t j = 0; j < weights[row].size(); ++j) {
    if (used.contains(j)) continue;
    std::set<std::size_t> more = used;
    more.insert(j);
    best = std::max(best, weights[row][j] + best_sum(weights, row + 1, more));
  }
  return best;
}

TEST(BestAssignment, ReachesTheBestSumOfAllAssignments) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> weight(-0.3, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t rows = 1 + random() % 6;
    const std::size_t columns = 1 + random() % 6;
    WeightTable weights(rows, std::vector<double>(columns));
    for (auto& row : weights) {
      for (double& w : row) w = weight(random);
    }
    const auto assigned = best_assignment(weights);
    EXPECT_NEAR(sum_of(weights, assigned), best_sum(weights), 1e-12);
    std::multiset<std::size_t> used;
    for (const auto& column : assigned) {
      if (column) used.insert(*column);
    }
    EXPECT_EQ(used.size(), std::set<std::size_t>(used.begin(), used.end()).size());
  }
}

TEST(BestAssignment, GivesUpTheGreatestPairWhereTwoOthersAreWorthMore) {
  const auto assigned = best_assignment({{0.6, 0.5}, {0.5, 0.0}});
  EXPECT_EQ(assigned[0], 1U);
  EXPECT_EQ(assigned[1], 0U);
}

TEST(BestAssignment, NeverPairsWhatHasNoWeight) {
  const auto assigned = best_assignment({{0.0, -1.0}, {0.0, 0.2}});
  EXPECT_EQ(assigned[0], std::nullopt);
  EXPECT_EQ(assigned[1], 1U);
}

TEST(BestAssignment, OfNothingIsNothing) {
  EXPECT_TRUE(best_assignment({}).empty());
  EXPECT_EQ(best_assignment({{}, {}}).size(), 2U);
}

}  // namespace
}  // namespace roomatlas
