// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/sonar/heading_slips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "heading_definition.hpp"
#include "roomatlas/core/pose2.hpp"

namespace roomatlas {
namespace {

constexpr double kAll = -1e9;  // log odds

/// The best of all ways whose end is accepted, one state after the other: from a little below the
/// reference, which is 0, to a little above a quarter turn beyond it.
double best_way(const HeadingDefinition& model, int sign, const std::function<bool(int)>& ends) {
  const int quarter = model.options.states;
  const int margin = quarter * 2 / 9;  // 20 degrees
  double best = -std::numeric_limits<double>::infinity();
  std::function<void(std::size_t, int, double)> walk = [&](std::size_t node, int at, double odds) {
    odds += std::log(model.seen(node, sign * at));
    if (node + 1 == model.nodes.size()) {
      if (ends(at)) best = std::max(best, odds);
      return;
    }
    for (int next = -margin; next <= quarter + margin; ++next) {
      const double moves = model.moves(node + 1, sign * (next - at));
      if (moves > 0.0) walk(node + 1, next, odds + std::log(moves));
    }
  };
  for (int at = -margin; 2 * at < quarter; ++at) walk(0, at, 0.0);
  return best;
}

TEST(FindSlips, HasTheOddsOfTheBestOfAllWays) {
  const HeadingDefinition model{four_nodes(), some_walls(), few_states()};
  const int quarter = model.options.states;
  const auto is_near = [&](int at) { return 2 * at < quarter; };
  double expected = -std::numeric_limits<double>::infinity();
  for (const int sign : {1, -1}) {
    expected = std::max(
        expected, best_way(model, sign, std::not_fn(is_near)) - best_way(model, sign, is_near));
  }
  const std::vector<double> reference(model.nodes.size(), 0.0);
  const auto slips = find_slips(model.nodes, model.walls, {{0.0}}, model.options, reference, kAll);
  ASSERT_FALSE(slips.empty());
  EXPECT_NEAR(slips.front().log_odds, expected, 1e-9);
}

/// Nodes every third of a metre along walls, but for a stretch without any, in which the robot
/// turns on the spot.
struct Drive {
  std::vector<HeadingNode> nodes;
  std::vector<WallSighting> walls;
};
Drive with_a_gap(std::size_t first, std::size_t last) {
  Drive drive;
  for (std::size_t k = 0; k < 200; ++k) {
    const double turns = static_cast<double>(std::clamp(k, first, last) - first);
    drive.nodes.push_back({0.3 * static_cast<double>(k), 3.0 * turns});
    if (k < first || k >= last) drive.walls.push_back({k, 0.0, 1.5});
  }
  return drive;
}

TEST(FindSlips, LooksWhereThereAreNoWalls) {
  const Drive drive = with_a_gap(90, 130);
  const std::vector<double> reference(drive.nodes.size(), 0.0);
  const auto slips = find_slips(drive.nodes, drive.walls, {{0.0}}, {}, reference, kAll);
  ASSERT_GE(slips.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {  // one to each side
    EXPECT_GE(slips[i].first_node, 85U);
    EXPECT_LE(slips[i].first_node + slips[i].more_rad.size(), 136U);
    EXPECT_NEAR(std::abs(degrees(slips[i].more_rad.back())), 90.0, 1e-9);
  }
  EXPECT_NEAR(slips[0].log_odds, slips[1].log_odds, 1e-6);
  EXPECT_LT(slips[0].more_rad.back() * slips[1].more_rad.back(), 0.0);
  if (slips.size() > 2) {
    EXPECT_LT(slips[2].log_odds, slips[1].log_odds - 5.0);
  }
}

TEST(FindSlips, AreLikelierTheLessIsSeen) {
  const std::vector<double> reference(200, 0.0);
  double before = -std::numeric_limits<double>::infinity();
  for (const std::size_t last : {100U, 120U, 140U}) {
    const Drive drive = with_a_gap(90, last);
    const auto slips = find_slips(drive.nodes, drive.walls, {{0.0}}, {}, reference, kAll);
    ASSERT_FALSE(slips.empty());
    EXPECT_GT(slips.front().log_odds, before);
    EXPECT_LT(slips.front().log_odds, 0.0);
    before = slips.front().log_odds;
  }
}

TEST(FindSlips, AreOnesOwnWayBackwards) {
  const Drive drive = with_a_gap(90, 130);
  const std::vector<double> reference(drive.nodes.size(), 0.0);
  const auto slips = find_slips(drive.nodes, drive.walls, {{0.0}}, {}, reference, kAll);
  ASSERT_FALSE(slips.empty());
  const HeadingSlip& slip = slips.front();
  std::vector<double> turned(drive.nodes.size(), slip.more_rad.back());
  for (std::size_t k = 0; k < slip.first_node + slip.more_rad.size(); ++k) {
    turned[k] = k < slip.first_node ? 0.0 : slip.more_rad[k - slip.first_node];
  }
  const auto back = find_slips(drive.nodes, drive.walls, {{0.0}}, {}, turned, kAll);
  ASSERT_FALSE(back.empty());
  EXPECT_NEAR(back.front().more_rad.back(), -slip.more_rad.back(), 1e-9);
  EXPECT_NEAR(back.front().log_odds, -slip.log_odds, 1.0);
}

TEST(FindSlips, KeepsOutWhatIsLessLikelyThanAsked) {
  const Drive drive = with_a_gap(90, 130);
  const std::vector<double> reference(drive.nodes.size(), 0.0);
  const auto all = find_slips(drive.nodes, drive.walls, {{0.0}}, {}, reference, kAll);
  const auto some =
      find_slips(drive.nodes, drive.walls, {{0.0}}, {}, reference, all.front().log_odds - 1.0);
  EXPECT_LT(some.size(), all.size());
  for (const HeadingSlip& slip : some) EXPECT_GE(slip.log_odds, all.front().log_odds - 1.0);
}

}  // namespace
}  // namespace roomatlas
