// SPDX-License-Identifier: GPL-3.0-or-later
// Which directions are kept, against worlds whose directions are known.
#include "../../src/sonar/sonar_choice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "../../src/sonar/free_map.hpp"
#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

struct Reconsidered {
  std::vector<double> directions_rad;
  std::size_t tried = 0;
  std::size_t chosen = 0;
  bool is_undirected_of_best = false;
  double strain_left = 0.0;
};

/// What is kept of a corridor that was solved with walls along one direction.
Reconsidered reconsidered(double angle_deg) {
  const test::DrivenWorld world = test::bent_corridor(angle_deg);
  const DriveDirections directions = find_drive_directions(world.readings, {});
  const SonarTrajectoryOptions options;
  const std::function<void()> nothing_before;
  const SonarMission mission{world.readings, directions, options, nothing_before};
  Choice choice;
  SonarTrajectory result;
  Idea straight = idea_of(mission, {}, {0.0});
  straight.attempt = solve(mission, straight, "straight", straight.heading.correction_rad);
  const double strain = straight.attempt.strain;
  choice.offer(std::move(straight), result);
  const Idea loose = reconsider_directions(mission, choice, result);
  const Idea again = undirected(mission, *choice.best);
  return {choice.best->attempt.directions_rad, result.variants.size(), result.chosen,
          loose.attempt.map_from_robot == again.attempt.map_from_robot,
          choice.best->attempt.strain / strain};
}

TEST(ReconsiderDirections, FindsTheWingThatWasMadeStraight) {
  const Reconsidered bent = reconsidered(10.0);
  ASSERT_EQ(bent.directions_rad.size(), 2U);
  EXPECT_NEAR(std::abs(degrees(wrap_quarter(bent.directions_rad[1] - bent.directions_rad[0]))),
              10.0, 2.0);
  EXPECT_LT(bent.strain_left, 0.9);
  EXPECT_EQ(bent.chosen, 1U);
  EXPECT_TRUE(bent.is_undirected_of_best);
}

TEST(ReconsiderDirections, LeavesAStraightOneStraight) {
  const Reconsidered straight = reconsidered(0.0);
  EXPECT_EQ(straight.directions_rad.size(), 1U);
  EXPECT_EQ(straight.chosen, 0U);
  EXPECT_TRUE(straight.is_undirected_of_best);
}

}  // namespace
}  // namespace roomatlas
