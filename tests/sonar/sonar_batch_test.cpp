// SPDX-License-Identifier: GPL-3.0-or-later
// The batch of poses and walls alone, on drives whose walls are known.
#include "../../src/sonar/sonar_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "roomatlas/core/rigid_fit.hpp"
#include "support/false_loops.hpp"

namespace roomatlas {
namespace {

/// A robot between two walls, to and fro; it hears each from near and from far.
SonarBatch to_and_fro(double length_scale) {
  constexpr double kWallM = 6.0;
  constexpr double kStepM = 0.4;
  SonarBatch batch;
  double x_m = 0.0;
  double ahead = 1.0;
  for (std::size_t k = 0; k < 150; ++k) {
    if (k > 0) {
      if (std::abs(x_m + ahead * kStepM) > kWallM - 1.0) ahead = -ahead;
      x_m += ahead * kStepM;
    }
    const double driven_m = k > 0 ? ahead * kStepM * length_scale : 0.0;
    const double from_m = k > 0 ? batch.map_from_node.back().x_m : 0.0;
    batch.map_from_node.push_back({from_m + driven_m, 0.0, 0.0});
    batch.steps.push_back({{driven_m, 0.0, 0.0}, 0.02, 0.02, 0.01});
    for (const double normal_rad : {0.0, kPi}) {
      const double to_wall_m = normal_rad == 0.0 ? kWallM - x_m : -kWallM - x_m;
      batch.walls.push_back(
          {k, normal_rad, {to_wall_m, 0.0}, 1.0, kStepM * static_cast<double>(k)});
    }
  }
  return batch;
}

TEST(SonarBatch, FindsTheScaleOfOdometrysLengths) {
  for (const double scale : {0.96, 0.98, 1.0, 1.02, 1.04}) {
    const SonarBatchResult result = solve_sonar_batch(to_and_fro(scale), {});
    ASSERT_TRUE(result.solved);
    EXPECT_NEAR(result.length_scale, 1.0 / scale, 0.002);
    EXPECT_LT(result.length_scale_sigma, 0.006);
  }
}

/// A corridor, and a wing behind it whose walls are turned by so much; odometry is exact.
SonarBatch with_a_wing(double turned_rad, double taken_for_rad) {
  SonarBatch batch;
  batch.directions_rad = {0.0, taken_for_rad};
  for (std::size_t k = 0; k < 60; ++k) {
    const bool is_wing = k >= 30;
    const double path_m = 0.4 * static_cast<double>(k);
    batch.map_from_node.push_back({path_m, 0.0, 0.0});
    batch.steps.push_back({{k > 0 ? 0.4 : 0.0, 0.0, 0.0}, 0.02, 0.02, 0.01});
    for (const double side_rad : {-kPi / 2.0, kPi / 2.0}) {
      const double normal_rad = side_rad + (is_wing ? turned_rad : 0.0);
      batch.walls.push_back(
          {k, normal_rad, direction(normal_rad), 1.0, path_m, 0.0, is_wing ? 1U : 0U});
    }
  }
  return batch;
}

TEST(SonarBatch, FindsHowFarAWingIsTurned) {
  for (const double turned_deg : {3.0, 7.0, 12.0}) {
    const SonarBatchResult result =
        solve_sonar_batch(with_a_wing(radians(turned_deg), radians(7.0)), {});
    ASSERT_TRUE(result.solved);
    ASSERT_EQ(result.directions_rad.size(), 2U);
    EXPECT_EQ(result.directions_rad[0], 0.0);
    EXPECT_NEAR(degrees(result.directions_rad[1]), turned_deg, 0.4);
    for (const Pose2& pose : result.map_from_node) EXPECT_NEAR(degrees(pose.theta_rad), 0.0, 0.4);
  }
}

/// How far poses may be off: root mean squares of what is drawn at the solution.
struct Spread {
  double place_m = 0.0;
  double heading_rad = 0.0;
};

std::vector<Spread> spread_at(const SonarBatch& batch, SonarBatchOptions options) {
  options.is_settled = true;
  const std::vector<std::vector<Pose2>> moves = solve_sonar_batch(batch, options).moves;
  std::vector<Spread> spread(batch.steps.size());
  for (std::size_t k = 0; k < spread.size(); ++k) {
    for (const std::vector<Pose2>& draw : moves) {
      spread[k].place_m += draw[k].position().squaredNorm();
      spread[k].heading_rad += draw[k].theta_rad * draw[k].theta_rad;
    }
    const auto draws = static_cast<double>(moves.size());
    spread[k] = {std::sqrt(spread[k].place_m / draws), std::sqrt(spread[k].heading_rad / draws)};
  }
  return spread;
}

TEST(SonarBatch, AWingsHeadingIsAsLooseAsTheWayThere) {
  const auto spread_of_last = [](SonarBatch batch) {
    batch.steps[30].turn_sigma_rad = 0.1;  // into the wing
    return spread_at(batch, {}).back().heading_rad;
  };
  SonarBatch rectangular = with_a_wing(0.0, 0.0);
  for (SeenWall& wall : rectangular.walls) wall.direction = 0;
  EXPECT_GT(spread_of_last(with_a_wing(0.1, 0.1)), 1.5 * spread_of_last(rectangular));
}

/// What the forward and the backward sonar hear from the nodes from `first` on.
std::vector<SeenReturn> returns_from(std::size_t first, const std::vector<Pose2>& truth,
                                     double wall_m) {
  std::vector<SeenReturn> returns;
  for (std::size_t k = first; k < truth.size(); ++k) {
    const double path_m = 0.4 * static_cast<double>(k);
    returns.push_back({k, {}, wall_m - truth[k].x_m, radians(10.0), path_m, 0.5});
    returns.push_back({k, {0.0, 0.0, kPi}, wall_m + truth[k].x_m, radians(10.0), path_m, 0.5});
  }
  return returns;
}

TEST(SonarBatch, ReturnsHoldNodesThatHeardNoStretch) {
  constexpr std::size_t kFirst = 75;  // half of the drive
  constexpr double kDriftM = 0.002;   // a step
  SonarBatch batch = to_and_fro(1.0);
  const std::vector<Pose2> truth = batch.map_from_node;
  std::erase_if(batch.walls, [](const SeenWall& wall) { return wall.node >= kFirst; });
  for (std::size_t k = kFirst; k < truth.size(); ++k) {
    batch.map_from_node[k].x_m += kDriftM * static_cast<double>(k + 1 - kFirst);
    batch.steps[k].before_from_here.x_m += kDriftM;
  }
  const auto off_m = [&] {
    const SonarBatchResult result = solve_sonar_batch(batch, {});
    EXPECT_TRUE(result.solved);
    return std::abs(result.map_from_node.back().x_m - truth.back().x_m);
  };
  EXPECT_GT(off_m(), 0.1);
  batch.returns = returns_from(kFirst, truth, 6.0);
  EXPECT_LT(off_m(), 0.03);
}

TEST(SonarBatch, KnowsNoScaleWithoutWallsSeenFromBothEnds) {
  SonarBatch beside = to_and_fro(1.02);
  for (std::size_t i = 0; i < beside.walls.size(); ++i) {  // along the way: they hold it across
    beside.walls[i].normal_rad += kPi / 2.0;
    beside.walls[i].middle_node = {0.0, i % 2 == 0 ? 1.0 : -1.0};
  }
  const SonarBatchOptions options;
  const SonarBatchResult result = solve_sonar_batch(beside, options);
  ASSERT_TRUE(result.solved);
  EXPECT_NEAR(result.length_scale, 1.0, 1e-6);
  EXPECT_NEAR(result.length_scale_sigma, options.length_sigma, 1e-6);
}

/// What is heard of walls from afar stands before them.
SonarBatch cluttered(double length_scale) {
  constexpr double kBeforeM = 0.09;
  SonarBatch batch = to_and_fro(length_scale);
  for (SeenWall& wall : batch.walls) {
    const double range_m = std::abs(wall.middle_node.x());
    if (range_m > 4.0 && wall.node % 3 != 0) wall.middle_node *= 1.0 - kBeforeM / range_m;
  }
  return batch;
}

TEST(SonarBatch, BelievesOdometrysLengthsInClutter) {
  const SonarBatch batch = cluttered(1.0);
  const SonarBatchResult result = solve_sonar_batch(batch, {});
  EXPECT_GT(result.clutter_m, 0.02);
  EXPECT_NEAR(result.length_scale, 1.0, 0.004);
  SonarBatchOptions believing;
  believing.clutter_m = 1.0;
  EXPECT_LT(solve_sonar_batch(batch, believing).length_scale, result.length_scale - 0.002);
}

TEST(SonarBatch, CountsAsClutterWhatScatterDoesNotExplain) {
  const std::vector<Pose2> poses = {{}, {}};
  const auto apart = [&](double between_m, double scatter_m) {
    const std::vector<SeenWall> walls = {{0, 0.0, {2.0, 0.0}, 1.0, 0.0, scatter_m},
                                         {1, 0.0, {2.0 + between_m, 0.0}, 1.0, 9.0, scatter_m}};
    return clutter_of(walls, {{0, 1, 0.0}}, poses);
  };
  EXPECT_NEAR(apart(0.05, 0.0), 0.05, 1e-9);
  EXPECT_NEAR(apart(0.05, 0.03), 0.04, 1e-9);
  EXPECT_EQ(apart(0.02, 0.03), 0.0);
  EXPECT_EQ(clutter_of({}, {}, {}), 0.0);
}

TEST(SonarBatch, StrainsOdometryWhereWallsMoveIt) {
  SonarBatch alone = to_and_fro(1.02);
  alone.walls.clear();
  EXPECT_LT(solve_sonar_batch(alone, {}).strain, 1e-9);

  const SonarBatch batch = to_and_fro(1.02);
  SonarBatchOptions options;
  options.start_length_sigma = 1e-6;
  options.length_sigma = 1e-6;  // the walls cannot change the scale: each step gives way
  const SonarBatchResult result = solve_sonar_batch(batch, options);
  double strain = 0.0;
  for (std::size_t k = 1; k < batch.steps.size(); ++k) {
    const DrivenStep& step = batch.steps[k];
    const Pose2 moved = inverse(result.map_from_node[k - 1]) * result.map_from_node[k];
    const double squares[] = {
        std::pow((moved.x_m - step.before_from_here.x_m) / step.along_sigma_m, 2),
        std::pow((moved.y_m - step.before_from_here.y_m) / step.across_sigma_m, 2),
        std::pow(
            wrap_angle(moved.theta_rad - step.before_from_here.theta_rad) / step.turn_sigma_rad,
            2)};
    for (const double square : squares) strain += 4.5 * std::log(1.0 + square / 9.0);
  }
  EXPECT_GT(strain, 0.1);
  EXPECT_NEAR(result.strain, strain, 1e-3 * strain);
}

/// How far nodes come to lie from where they are once they are laid on them, over many drives whose
/// steps err by their sigmas.
std::vector<double> driven_spread_m(const SonarBatch& batch, double length_sigma) {
  constexpr int kDrives = 4000;
  test::Dice dice(5);
  std::vector<double> squares(batch.steps.size(), 0.0);
  for (int drive = 0; drive < kDrives; ++drive) {
    std::vector<Pose2> driven{batch.map_from_node.front()};
    const double scale = 1.0 + length_sigma * dice.normal();
    for (std::size_t k = 1; k < batch.steps.size(); ++k) {
      const DrivenStep& step = batch.steps[k];
      driven.push_back(
          driven.back() *
          Pose2{scale * step.before_from_here.x_m + step.along_sigma_m * dice.normal(),
                step.across_sigma_m * dice.normal(),
                step.before_from_here.theta_rad + step.turn_sigma_rad * dice.normal()});
    }
    std::vector<PointPair> pairs;
    for (std::size_t k = 0; k < driven.size(); ++k) {
      pairs.push_back({driven[k].position(), batch.map_from_node[k].position()});
    }
    const Pose2 laid = rigid_fit(pairs);
    for (std::size_t k = 0; k < driven.size(); ++k) {
      squares[k] += (laid * pairs[k].from - pairs[k].to).squaredNorm() / kDrives;
    }
  }
  for (double& one : squares) one = std::sqrt(one);
  return squares;
}

TEST(SonarBatch, SpreadsAsManyDrivesDo) {
  SonarBatch batch;
  Pose2 at;
  for (std::size_t k = 0; k < 60; ++k) {
    const Pose2 step{0.4, 0.0, k % 20 == 19 ? kPi / 2.0 : 0.0};
    if (k > 0) at = at * step;
    batch.map_from_node.push_back(at);
    batch.steps.push_back({step, 0.02, 0.03, 0.01});
  }
  SonarBatchOptions options;
  options.length_sigma = 0.01;
  const std::vector<Spread> spread = spread_at(batch, options);
  const std::vector<double> expected_m = driven_spread_m(batch, options.length_sigma);
  ASSERT_EQ(spread.size(), expected_m.size());
  double ratio = 0.0;  // in the mean, since few draws tell a single node's to a tenth
  for (std::size_t k = 0; k < expected_m.size(); ++k) {
    EXPECT_NEAR(spread[k].place_m / expected_m[k], 1.0, 0.4) << k;
    ratio += spread[k].place_m / expected_m[k] / 60.0;
  }
  EXPECT_NEAR(ratio, 1.0, 0.1);
}

TEST(SonarBatch, WallsHoldWhatDrivesSpread) {
  SonarBatch alone = to_and_fro(1.0);
  alone.walls.clear();
  const std::vector<Spread> held = spread_at(to_and_fro(1.0), {});
  const std::vector<Spread> loose = spread_at(alone, {});
  for (std::size_t k = 0; k < held.size(); ++k) {
    EXPECT_LT(held[k].heading_rad, 0.5 * loose[k].heading_rad) << k;
  }
}

/// The mean of how far the wild draws move the poses, metres.
double wild_m(const SonarBatch& batch) {
  SonarBatchOptions options;
  options.is_settled = true;
  const std::vector<std::vector<Pose2>> draws = solve_sonar_batch(batch, options).wild;
  double sum_m = 0.0;
  for (const std::vector<Pose2>& draw : draws) {
    for (const Pose2& move : draw) sum_m += move.position().norm();
  }
  return sum_m / static_cast<double>(draws.size() * batch.steps.size());
}

/// What is left open is the same in both; what contradicts itself is not.
TEST(SonarBatch, IsPulledByWallsThatContradictEachOther) {
  const SonarBatch agreeing = to_and_fro(1.0);
  SonarBatch contradicting = agreeing;
  for (SeenWall& wall : contradicting.walls) {  // each half of the mission has the room otherwise
    if (wall.node % 50 < 25) wall.middle_node.x() += 0.04;
  }
  EXPECT_LT(wild_m(agreeing), 1e-6);
  EXPECT_GT(wild_m(contradicting), 0.0005);
  const double held_m = spread_at(agreeing, {}).at(75).place_m;
  EXPECT_NEAR(spread_at(contradicting, {}).at(75).place_m, held_m, 0.2 * held_m);
}

}  // namespace
}  // namespace roomatlas
