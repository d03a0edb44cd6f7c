// SPDX-License-Identifier: GPL-3.0-or-later
// The metrics against matrices written out by hand, and the choice of pairs against its definition.
#include "roomatlas/evaluate/ape_rpe.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "evaluate/drives.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

using Eigen::Matrix4d;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

Matrix4d matrix_of(const Pose2& pose) {
  Matrix4d matrix = Matrix4d::Identity();
  matrix(0, 0) = matrix(1, 1) = std::cos(pose.theta_rad);
  matrix(1, 0) = std::sin(pose.theta_rad);
  matrix(0, 1) = -matrix(1, 0);
  matrix(0, 3) = pose.x_m;
  matrix(1, 3) = pose.y_m;
  return matrix;
}

double literal_size(const Matrix4d& error, PoseRelation relation) {
  const double angle =
      std::acos(std::clamp((error.topLeftCorner<3, 3>().trace() - 1.0) / 2.0, -1.0, 1.0));
  switch (relation) {
    case PoseRelation::full:
      return (error - Matrix4d::Identity()).norm();
    case PoseRelation::rot_part:
      return (error.topLeftCorner<3, 3>() - Eigen::Matrix3d::Identity()).norm();
    case PoseRelation::angle_deg:
      return angle * 180.0 / std::acos(-1.0);
    case PoseRelation::angle_rad:
      return angle;
    default:
      return error.topRightCorner<3, 1>().norm();
  }
}

constexpr std::array kByMatrix = {PoseRelation::full, PoseRelation::trans_part,
                                  PoseRelation::rot_part, PoseRelation::angle_deg,
                                  PoseRelation::angle_rad};

TEST(Ape, IsTheErrorMatrixsPartForEveryRelation) {
  const MatchedPoses matched = test::matched_drives(80);
  for (const PoseRelation relation : kByMatrix) {
    const PoseErrors errors = ape(matched, {relation, Alignment::none, -1});
    ASSERT_EQ(errors.errors.size(), 80U);
    for (std::size_t i = 0; i < 80; ++i) {
      const Matrix4d error = matrix_of(matched.estimate_from_robot[i]).inverse() *
                             matrix_of(matched.truth_from_robot[i]);
      EXPECT_NEAR(errors.errors[i], literal_size(error, relation), 1e-6) << to_string(relation);
    }
  }
}

TEST(Ape, IsZeroAfterAlignmentOfADriveInAnotherFrame) {
  const MatchedPoses matched = test::matched_drives(80, 0.0);
  EXPECT_GT(ape(matched, {PoseRelation::full, Alignment::none, -1}).statistics.minimum, 1.0);
  EXPECT_LT(ape(matched, {PoseRelation::full, Alignment::origin, -1}).statistics.maximum, 1e-9);
  EXPECT_LT(ape(matched, {PoseRelation::full, Alignment::umeyama, -1}).statistics.maximum, 1e-9);
}

TEST(Ape, OfOriginAlignmentIsZeroAtTheFirstPose) {
  const PoseErrors errors =
      ape(test::matched_drives(80), {PoseRelation::full, Alignment::origin, -1});
  EXPECT_LT(errors.errors.front(), 1e-12);
  EXPECT_GT(errors.errors.back(), 1e-3);
}

TEST(Ape, OfADistanceRatioIsNotDefined) {
  EXPECT_THROW((void)ape(test::matched_drives(5),
                         {PoseRelation::point_distance_error_ratio, Alignment::none, -1}),
               std::invalid_argument);
}

double sum_of_squares(const MatchedPoses& matched, const Pose2& motion) {
  double sum = 0.0;
  for (std::size_t i = 0; i < matched.size(); ++i) {
    sum += (motion * matched.estimate_from_robot[i].position() -
            matched.truth_from_robot[i].position())
               .squaredNorm();
  }
  return sum;
}

TEST(UmeyamaAlignment, IsWhatASearchOverAllMotionsEndsAt) {
  const MatchedPoses matched = test::matched_drives(60, 0.3);
  Pose2 best;
  double least = sum_of_squares(matched, best);
  for (double step = 4.0; step > 1e-9;) {  // pattern search from the identity
    bool is_better = false;
    for (const Pose2& move : {Pose2{step, 0, 0},
                              {-step, 0, 0},
                              {0, step, 0},
                              {0, -step, 0},
                              {0, 0, step / 4},
                              {0, 0, -step / 4}}) {
      const Pose2 tried{best.x_m + move.x_m, best.y_m + move.y_m, best.theta_rad + move.theta_rad};
      const double sum = sum_of_squares(matched, tried);
      if (sum >= least) continue;
      least = sum;
      best = tried;
      is_better = true;
    }
    if (!is_better) step /= 2.0;
  }
  const Pose2 found = truth_from_estimate(matched, Alignment::umeyama);
  EXPECT_NEAR(found.x_m, best.x_m, 1e-4);
  EXPECT_NEAR(found.y_m, best.y_m, 1e-4);
  EXPECT_NEAR(wrap_angle(found.theta_rad - best.theta_rad), 0.0, 1e-5);
  EXPECT_LE(sum_of_squares(matched, found), least + 1e-9);
}

TEST(UmeyamaAlignment, UsesTheFirstPosesOnlyWhereAsked) {
  MatchedPoses matched = test::matched_drives(60, 0.0);
  for (std::size_t i = 20; i < 60; ++i) matched.estimate_from_robot[i].x_m += 5.0;
  const PoseErrors errors = ape(matched, {PoseRelation::trans_part, Alignment::umeyama, 20});
  EXPECT_LT(errors.errors[19], 1e-9);
  EXPECT_NEAR(errors.errors[20], 5.0, 1e-9);
}

TEST(UmeyamaAlignment, OfOnePlaceMovesAndDoesNotTurn) {
  MatchedPoses matched;
  matched.timestamps_s = {1.0};
  matched.estimate_from_robot = {{1, 2, 0.5}};
  matched.truth_from_robot = {{4, 6, 0.9}};
  EXPECT_EQ(truth_from_estimate(matched, Alignment::umeyama), (Pose2{3, 4, 0}));
  EXPECT_EQ(truth_from_estimate({}, Alignment::umeyama), Pose2{});
}

TEST(Rpe, IsTheErrorMatrixsPartForEveryRelation) {
  const MatchedPoses matched = test::matched_drives(60);
  for (const PoseRelation relation : kByMatrix) {
    RpeOptions options;
    options.relation = relation;
    options.delta = 7;
    options.all_pairs = true;
    const PoseErrors errors = rpe(matched, options);
    ASSERT_EQ(errors.errors.size(), 53U);
    for (std::size_t i = 0; i < 53; ++i) {
      const Matrix4d truth = matrix_of(matched.truth_from_robot[i]).inverse() *
                             matrix_of(matched.truth_from_robot[i + 7]);
      const Matrix4d estimate = matrix_of(matched.estimate_from_robot[i]).inverse() *
                                matrix_of(matched.estimate_from_robot[i + 7]);
      EXPECT_NEAR(errors.errors[i], literal_size(truth.inverse() * estimate, relation), 1e-6);
    }
  }
}

TEST(Rpe, OfPointDistanceComparesLengthsAndLeavesZeroLengthsOutOfRatios) {
  MatchedPoses matched;
  matched.timestamps_s = {0, 1, 2};
  matched.truth_from_robot = {{0, 0, 0}, {3, 4, 1}, {3, 4, 2}};
  matched.estimate_from_robot = {{0, 0, 0}, {0, 6, 0}, {0, 7, 0}};
  RpeOptions options;
  options.relation = PoseRelation::point_distance;
  EXPECT_EQ(rpe(matched, options).errors, (std::vector<double>{1.0, 1.0}));
  options.relation = PoseRelation::point_distance_error_ratio;
  const PoseErrors ratio = rpe(matched, options);
  ASSERT_EQ(ratio.errors.size(), 1U);
  EXPECT_NEAR(ratio.errors[0], 20.0, 1e-12);
  EXPECT_EQ(ratio.zero_distances, 1);
}

TEST(Rpe, DoesNotChangeWhenEitherTrajectoryMovesAsAWhole) {
  MatchedPoses matched = test::matched_drives(60);
  RpeOptions options;
  options.delta = 3;
  const double before = rpe(matched, options).statistics.rmse;
  for (Pose2& pose : matched.estimate_from_robot) pose = Pose2{9, -4, 2} * pose;
  for (Pose2& pose : matched.truth_from_robot) pose = Pose2{-1, 3, 0.5} * pose;
  EXPECT_NEAR(rpe(matched, options).statistics.rmse, before, 1e-12);
}

std::vector<Pose2> poses_of(std::size_t count) {
  return test::matched_drives(count).estimate_from_robot;
}

double turn_between(const Pose2& a, const Pose2& b) {
  return std::abs(std::remainder(b.theta_rad - a.theta_rad, 2.0 * std::acos(-1.0)));
}

TEST(DeltaPairs, ByFramesLieEndToEndOrBeginEverywhere) {
  EXPECT_EQ(delta_pairs(std::vector<Pose2>(7), {.delta = 3}), (Pairs{{0, 3}, {3, 6}}));
  EXPECT_EQ(delta_pairs(std::vector<Pose2>(5), {.delta = 3, .all_pairs = true}),
            (Pairs{{0, 3}, {1, 4}}));
  EXPECT_TRUE(delta_pairs(std::vector<Pose2>(3), {.delta = 3}).empty());
  EXPECT_TRUE(delta_pairs({}, {.delta = 1}).empty());
}

TEST(DeltaPairs, ByMetresOfAllPosesTakeTheNearestPathLengthWithinTolerance) {
  const std::vector<Pose2> poses = poses_of(90);
  const auto path = [&](std::size_t i, std::size_t j) {
    double sum = 0.0;
    for (; i < j; ++i) sum += (poses[i + 1].position() - poses[i].position()).norm();
    return sum;
  };
  Pairs expected;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    std::size_t best = i + 1;
    for (std::size_t j = i + 1; j < poses.size(); ++j) {
      if (std::abs(path(i, j) - 1.5) < std::abs(path(i, best) - 1.5)) best = j;
    }
    if (std::abs(path(i, best) - 1.5) <= 0.03) expected.emplace_back(i, best);
  }
  ASSERT_GT(expected.size(), 5U);
  ASSERT_LT(expected.size(), 80U);
  EXPECT_EQ(
      delta_pairs(
          poses,
          {.delta = 1.5, .unit = DeltaUnit::metres, .all_pairs = true, .relative_tolerance = 0.02}),
      expected);
}

TEST(DeltaPairs, ByMetresEndToEndBeginWhereDeltaWasFirstDriven) {
  std::vector<Pose2> poses;
  for (int i = 0; i < 11; ++i) poses.push_back({0.4 * i, 0, 0});
  EXPECT_EQ(delta_pairs(poses, {.delta = 1.0, .unit = DeltaUnit::metres}), (Pairs{{3, 6}, {6, 9}}));
}

TEST(DeltaPairs, ByAngleSumTurnsEndToEndOrCompareHeadings) {
  const std::vector<Pose2> poses = poses_of(70);
  Pairs expected;
  std::size_t start = 0;
  double sum = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    sum += turn_between(poses[i - 1], poses[i]);
    if (sum < radians(40.0)) continue;
    expected.emplace_back(start, i);
    start = i;
    sum = 0.0;
  }
  ASSERT_GT(expected.size(), 3U);
  EXPECT_EQ(delta_pairs(poses, {.delta = 40.0, .unit = DeltaUnit::degrees}), expected);

  Pairs all;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t j = i + 1; j < poses.size(); ++j) {
      const double turn = turn_between(poses[i], poses[j]);
      if (turn >= 0.9 && turn <= 1.1) all.emplace_back(i, j);
    }
  }
  ASSERT_GT(all.size(), 10U);
  EXPECT_EQ(delta_pairs(poses, {.delta = 1.0, .unit = DeltaUnit::radians, .all_pairs = true}), all);
}

TEST(DeltaPairs, RefuseWhatIsNoDistance) {
  const std::vector<Pose2> poses(9);
  EXPECT_THROW((void)delta_pairs(poses, {.delta = 1.5}), UsageError);
  EXPECT_THROW((void)delta_pairs(poses, {.delta = 0}), UsageError);
  EXPECT_THROW((void)delta_pairs(poses, {.delta = -1, .unit = DeltaUnit::metres}), UsageError);
  EXPECT_THROW((void)delta_pairs(poses, {.delta = 181, .unit = DeltaUnit::degrees}), UsageError);
}

TEST(MatchPoses, LookTheShorterTrajectorysTimesUpInTheLongerOne) {
  const Trajectory truth = test::bent(100);
  Trajectory sparse = {truth[3], truth[50], {1.0, {}}};
  const MatchedPoses matched = match_poses(sparse, truth, {});
  EXPECT_EQ(matched.size(), 2U);
  EXPECT_EQ(matched.truth_from_robot[1], truth[50].pose);
  const MatchedPoses turned = match_poses(truth, sparse, {});
  EXPECT_EQ(turned.timestamps_s, matched.timestamps_s);
  EXPECT_EQ(turned.estimate_from_robot[1], truth[50].pose);
}

}  // namespace
}  // namespace roomatlas
