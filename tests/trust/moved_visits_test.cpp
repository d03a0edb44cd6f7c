// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/trust/moved_visits.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace roomatlas {
namespace {

/// Two solutions of two visits. The first visit's path lies 3 m from its frame's origin: turned
/// about its own middle it stays where it is.
TEST(MapMoves, AreThoseOfVisitsMiddles) {
  const std::map<AsrId, Point2> centres = {{1, {3.0, 0.0}}, {2, {0.0, 0.0}}};
  const double turn_rad = radians(4.0);
  const Pose2 about_its_middle = Pose2{3.0, 0.0, turn_rad} * Pose2{-3.0, 0.0, 0.0};
  MovedVisits moved;
  moved[1] = {about_its_middle, {0.0, 0.0, 0.0}};
  moved[2] = {{0.3, 0.4, 0.0}, {0.0, 0.1, radians(-1.0)}};

  const MapMoves moves = map_moves(moved, centres);
  EXPECT_NEAR(moves.visits.at(1).place_m, 0.0, 1e-12);
  EXPECT_NEAR(moves.visits.at(1).heading_rad, turn_rad / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(moves.visits.at(2).place_m, std::sqrt((0.25 + 0.01) / 2.0), 1e-12);
  EXPECT_NEAR(moves.place_m, std::sqrt((0.25 + 0.01) / 4.0), 1e-12);
  EXPECT_NEAR(moves.worst.place_m, std::sqrt((0.25 + 0.01) / 2.0), 1e-12);
  EXPECT_NEAR(degrees(moves.worst.heading_rad), std::sqrt((16.0 + 1.0) / 2.0), 1e-9);
  // 4 of 2 degrees or 0.5 of 0.25 m; 1 of 2 degrees or 0.1 of 0.25 m
  EXPECT_NEAR(moves.log_off, (std::log(2.0) + std::log(0.5)) / 2.0, 1e-9);
}

TEST(MapMoves, WithoutSolutionsNothingIsKnown) {
  const MapMoves moves = map_moves({}, {{1, {0.0, 0.0}}});
  EXPECT_GE(moves.place_m, 10.0);
  EXPECT_GE(moves.visits.at(1).heading_rad, kPi);
  EXPECT_GT(moves.log_off, std::log(10.0));
}

}  // namespace
}  // namespace roomatlas
