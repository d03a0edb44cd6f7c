// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of the attempt that was kept.
#include "../../src/sonar/sonar_rivals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "../../src/sonar/free_map.hpp"
#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

Attempt attempt_at(const std::vector<Pose2>& poses, double score_m) {
  Attempt attempt;
  attempt.map_from_robot = poses;
  attempt.score_m = score_m;
  return attempt;
}

TEST(AttemptsApart, WeighsThoseThatDoNearlyAsWellAndNotHowTheyLie) {
  const std::vector<Pose2> there = {{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {12, 0, 0}};
  std::vector<Pose2> turned = there;
  for (Pose2& pose : turned) pose = Pose2{3.0, -2.0, 1.0} * pose;
  std::vector<Pose2> longer = there;  // by 0.6 m a pose: 0.9, 0.3, 0.3 and 0.9 m off
  for (std::size_t i = 0; i < longer.size(); ++i) longer[i].x_m += 0.6 * static_cast<double>(i);
  const double off_m = std::sqrt((0.81 + 0.09 + 0.09 + 0.81) / 4.0);

  const Attempt kept = attempt_at(there, 100.0);
  EXPECT_EQ(attempts_apart(kept, {}), 0.0);
  EXPECT_NEAR(attempts_apart(kept, {attempt_at(turned, 100.0)}), 0.0, 1e-9);
  EXPECT_NEAR(attempts_apart(kept, {attempt_at(longer, 100.0)}), off_m / std::sqrt(2.0), 1e-9);
  EXPECT_LT(attempts_apart(kept, {attempt_at(longer, 50.0)}), 0.01 * off_m);
}

/// Up a corridor and on at an angle.
std::vector<Pose2> bent(double angle_rad) {
  const Point2 along = direction(angle_rad);
  return {{-2, 0, 0},
          {-1, 0, 0},
          {along.x(), along.y(), angle_rad},
          {2.0 * along.x(), 2.0 * along.y(), angle_rad}};
}

TEST(HeadingsApart, WeighsThoseInDirectionsThatFitNearlyAsWell) {
  const Attempt kept = attempt_at(bent(0.0), 100.0);
  Attempt other = attempt_at(bent(0.1), 100.0);
  // laid on the other by its places it is turned by half the angle: + and - 0.05 rad
  EXPECT_NEAR(headings_apart(kept, {other}), 0.05 / std::sqrt(2.0), 0.001);
  EXPECT_NEAR(headings_apart(kept, {other, other, other}), 0.05 * std::sqrt(0.75), 0.001);
  other.strain = 25.0;
  const double weight = std::exp(-1.0);
  EXPECT_NEAR(headings_apart(kept, {other}), 0.05 * std::sqrt(weight / (1.0 + weight)), 0.001);
  other.is_free = true;
  EXPECT_EQ(headings_apart(kept, {other}), 0.0);
}

TEST(CrossCheck, IsByTheMapGrownAloneUnlessThatIsKept) {
  Attempt kept = attempt_at(bent(0.0), 100.0);
  Attempt grown_map = attempt_at(bent(0.1), 90.0);
  grown_map.is_free = true;
  const Attempt worse = attempt_at(bent(0.4), 50.0);
  const Attempt better = attempt_at(bent(0.2), 80.0);
  const CrossCheck of_directed = cross_checked(kept, grown_map, {worse, better});
  ASSERT_EQ(of_directed.moves.of_draw.size(), 1U);
  EXPECT_NEAR(of_directed.moves.of_draw[0].back().theta_rad, 0.05, 0.001);
  EXPECT_NEAR(of_directed.merit_share, 0.1, 1e-9);

  kept.is_free = true;
  const CrossCheck of_free = cross_checked(kept, kept, {worse, better, grown_map});
  EXPECT_NEAR(of_free.moves.of_draw.at(0).back().theta_rad, 0.1, 0.002);
  EXPECT_NEAR(of_free.merit_share, 0.2, 1e-9);
  EXPECT_TRUE(cross_checked(kept, kept, {grown_map}).moves.of_draw.empty());
}

/// The mean over the mission of how far directions turn it, degrees.
double directed_deg(const test::DrivenWorld& world, const std::vector<double>& directions_rad) {
  const SonarTrajectoryOptions options;
  const DriveDirections directions = find_drive_directions(world.readings, {});
  const SonarMission mission{world.readings, directions, options, {}};
  Idea idea = idea_of(mission, {}, directions_rad);
  idea.attempt = solve(mission, idea, "", idea.heading.correction_rad);
  const DrawnMoves moves = moves_of_readings(undirected(mission, idea).attempt.map_from_robot,
                                             idea.attempt.map_from_robot);
  const std::vector<Pose2>& one = moves.of_draw.at(0);
  const double sum_rad = std::accumulate(
      moves.node_of.begin(), moves.node_of.end(), 0.0,
      [&](double sum, std::size_t k) { return sum + std::abs(one.at(k).theta_rad); });
  return degrees(sum_rad) / static_cast<double>(world.readings.size());
}

/// Walls that are held to follow a direction that they do not follow bend the way between them.
TEST(Undirected, ShowsABuildingThatWasMadeSquare) {
  const test::DrivenWorld corridor = test::bent_corridor(9.0);
  const double square_deg = directed_deg(corridor, {0.0});
  const double bent_deg = directed_deg(corridor, {0.0, radians(9.0)});
  EXPECT_GT(square_deg, 2.0);
  EXPECT_LT(bent_deg, 0.5 * square_deg);
}

Idea idea_with(double score_m, double strain) {
  Idea idea;
  idea.attempt.score_m = score_m;
  idea.attempt.strain = strain;
  return idea;
}

TEST(TakesOver, WallsThatFollowNoDirectionMustFitFarBetter) {
  const auto takes = [](double more, double best) {
    Idea free = idea_with(best + more, 0.0);
    free.is_free = true;
    free.is_open = true;  // as the idea that it was begun from
    return takes_over(free, idea_with(best + 10.0, 10.0));
  };
  EXPECT_FALSE(takes(24.0, 100.0));
  EXPECT_TRUE(takes(26.0, 100.0));
  EXPECT_FALSE(takes(49.0, 1000.0));  // of a large mission a share
  EXPECT_TRUE(takes(51.0, 1000.0));
}

TEST(TakesOver, WhereWallsFollowDirectionsByChanceAloneTheyNeedNotFit) {
  Idea free = idea_with(101.0, 0.0);
  free.is_free = true;
  free.followed_share = 0.3;
  EXPECT_TRUE(takes_over(free, idea_with(110.0, 10.0)));
  EXPECT_FALSE(takes_over(free, idea_with(112.0, 10.0)));
  free.followed_share = 0.4;
  EXPECT_FALSE(takes_over(free, idea_with(110.0, 10.0)));
}

TEST(TakesOver, NobodyByAScoreThatOdometryPaysFor) {
  EXPECT_TRUE(takes_over(idea_with(150.0, 30.0), idea_with(100.0, 10.0)));
  EXPECT_FALSE(takes_over(idea_with(150.0, 70.0), idea_with(100.0, 10.0)));
}

/// How far headings against the first are off, mean, degrees; with walls along one direction or
/// none.
double headings_off_deg(const test::DrivenWorld& corridor, bool is_free) {
  const SonarTrajectoryOptions options;
  const DriveDirections directions = find_drive_directions(corridor.readings, {});
  const SonarMission mission{corridor.readings, directions, options, {}};
  Idea idea = idea_of(mission, {}, {0.0});
  idea.is_free = is_free;
  idea.attempt = solve(mission, idea, "", idea.heading.correction_rad);
  double off_rad = 0.0;
  const auto& found = idea.attempt.map_from_robot;
  for (std::size_t i = 0; i < found.size(); ++i) {
    off_rad += std::abs(wrap_angle((found[i].theta_rad - found[0].theta_rad) -
                                   (corridor.truth[i].theta_rad - corridor.truth[0].theta_rad)));
  }
  return degrees(off_rad) / static_cast<double>(found.size());
}

TEST(FreeWalls, LeaveABuildingAsOdometryAndWallsSeenAgainHaveIt) {
  const test::DrivenWorld corridor = test::bent_corridor(9.0);
  EXPECT_LT(headings_off_deg(corridor, true), 0.5 * headings_off_deg(corridor, false));
}

}  // namespace
}  // namespace roomatlas
