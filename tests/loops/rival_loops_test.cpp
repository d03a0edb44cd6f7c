// SPDX-License-Identifier: GPL-3.0-or-later
// A second answer of a mission with a laser.
#include "../../src/loops/rival_loops.hpp"

#include <gtest/gtest.h>

namespace roomatlas {
namespace {

constexpr double kCellM = 0.1;
constexpr std::size_t kRooms = 8;

Closure agreeing_at(AsrId from, AsrId to, int points) {
  Closure closure{from, to, {}, ClosureVerdict::accepted, false};
  closure.match.agreeing = points;
  return closure;
}

/// Rooms in a row, the last of them moved; each matches the next with so many points.
LoopsState in_a_row(double last_moved_m, int last_points) {
  LoopsState state{PlacedGraph(2.0), {}, {}, {}};
  for (std::size_t i = 0; i < kRooms; ++i) {
    const double moved_m = i + 1 == kRooms ? last_moved_m : 0.0;
    state.placed.add_node(static_cast<AsrId>(i + 1), {5.0 * static_cast<double>(i), moved_m, 0.0});
  }
  for (std::size_t i = 0; i + 1 < kRooms; ++i) {
    const auto id = static_cast<AsrId>(i + 1);
    state.pairs.push_back({i, i + 1, 0.0});
    state.closures.push_back(agreeing_at(id, id + 1, i + 2 == kRooms ? last_points : 400));
  }
  return state;
}

std::optional<RivalLoops> rival_to(const LoopsState& kept, const std::vector<LoopsState>& states) {
  return rival_of(kept, states, kRooms, kCellM);
}

TEST(RivalLoops, ThatExplainNearlyAsMuchElsewhereAreASecondAnswer) {
  const auto rival = rival_to(in_a_row(0.0, 200), {in_a_row(2.0, 190)});
  ASSERT_TRUE(rival.has_value());
  EXPECT_EQ(rival->second.visits, 1);
  EXPECT_DOUBLE_EQ(rival->second.farthest_m, 2.0);
  EXPECT_DOUBLE_EQ(rival->second.score_m, 19.0);  // only the match of the room that moved
  EXPECT_DOUBLE_EQ(rival->second.kept_m, 20.0);
}

TEST(RivalLoops, ThatExplainLessAreNone) {
  EXPECT_FALSE(rival_to(in_a_row(0.0, 200), {in_a_row(2.0, 150)}).has_value());
}

TEST(RivalLoops, ThatPutRoomsInTheSamePlacesAreNone) {
  EXPECT_FALSE(rival_to(in_a_row(0.0, 200), {in_a_row(0.3, 200)}).has_value());
}

TEST(RivalLoops, OfSeveralTheBestCounts) {
  const auto rival =
      rival_to(in_a_row(0.0, 200), {in_a_row(1.0, 180), in_a_row(2.0, 195), in_a_row(3.0, 190)});
  ASSERT_TRUE(rival.has_value());
  EXPECT_EQ(rival->which, 1U);
}

TEST(RivalLoops, OfNoneIsNone) { EXPECT_FALSE(rival_to(in_a_row(0.0, 200), {}).has_value()); }

}  // namespace
}  // namespace roomatlas
