// SPDX-License-Identifier: GPL-3.0-or-later
// Whole missions of a sonar ring in small worlds.
#include "roomatlas/sonar/sonar_trajectory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../../src/sonar/node_headings.hpp"
#include "../../src/sonar/sonar_attempt.hpp"
#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

using test::bent_corridor;
using test::drive;
using test::DrivenWorld;

/// Twice round a square corridor, 1.8 m wide.
DrivenWorld square_corridor(double drift_deg_per_m) {
  auto walls = test::walls_along({{0, 0}, {14, 0}, {14, 11}, {0, 11}}, true);
  const auto inner = test::walls_along({{1.8, 1.8}, {12.2, 1.8}, {12.2, 9.2}, {1.8, 9.2}}, true);
  walls.insert(walls.end(), inner.begin(), inner.end());
  std::vector<Point2> points = {{0.9, 0.9}};
  for (int lap = 0; lap < 2; ++lap) {
    points.insert(points.end(), {{13.1, 0.9}, {13.1, 10.1}, {0.9, 10.1}, {0.9, 0.9}});
  }
  return drive(walls, points, drift_deg_per_m);
}

struct Error {
  double position_m = 0.0;
  double heading_deg = 0.0;
};

/// The largest error; both trajectories begin at the same pose.
Error largest_error(const DrivenWorld& mission, const std::vector<Pose2>& poses) {
  Error error;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose2 off = inverse(mission.truth[i]) * poses[i];
    error.position_m = std::max(error.position_m, off.position().norm());
    error.heading_deg = std::max(error.heading_deg, std::abs(degrees(off.theta_rad)));
  }
  return error;
}

std::vector<Pose2> odometry_of(const DrivenWorld& mission) {
  std::vector<Pose2> poses;
  for (const RangeReading& reading : mission.readings) poses.push_back(reading.odom_from_robot);
  return poses;
}

TEST(SonarTrajectory, TakesADriftOutOfASquareMission) {
  for (const double drift : {-2.5, 0.6}) {
    const DrivenWorld mission = square_corridor(drift);
    EXPECT_GT(largest_error(mission, odometry_of(mission)).position_m, 2.0);
    const SonarTrajectory result =
        correct_sonar_trajectory(mission.readings, find_drive_directions(mission.readings, {}), {});
    ASSERT_EQ(result.map_from_robot.size(), mission.truth.size());
    const Error error = largest_error(mission, result.map_from_robot);
    EXPECT_LT(error.position_m, 0.25) << drift;
    EXPECT_LT(error.heading_deg, 3.0) << drift;
    EXPECT_NEAR(degrees(result.habits.bias_rad_per_m), -drift, 0.4);
    EXPECT_TRUE(result.loops_verified);
    EXPECT_EQ(result.slips_repaired, 0);
  }
}

/// Each turn that odometry reports, times a gain.
void turn_by(std::vector<RangeReading>& readings, double gain) {
  Pose2 before = readings.front().odom_from_robot;
  Pose2 pose = before;
  for (RangeReading& reading : readings) {
    Pose2 step = inverse(before) * reading.odom_from_robot;
    before = reading.odom_from_robot;
    step.theta_rad *= gain;
    pose = pose * step;
    reading.odom_from_robot = pose;
  }
}

TEST(SonarTrajectory, FindsThatOdometryTurnsTooLittle) {
  DrivenWorld mission = square_corridor(0.5);
  turn_by(mission.readings, 0.9);
  EXPECT_GT(largest_error(mission, odometry_of(mission)).heading_deg, 20.0);
  const SonarTrajectory result =
      correct_sonar_trajectory(mission.readings, find_drive_directions(mission.readings, {}), {});
  const Error error = largest_error(mission, result.map_from_robot);
  EXPECT_LT(error.position_m, 0.4);
  EXPECT_LT(error.heading_deg, 4.0);
  EXPECT_GT(result.habits.turn_gain, 1.0);
}

/// Odometry turns by so much too far along some readings, in which no sonar hears anything.
void turn_unheard(std::vector<RangeReading>& readings, std::size_t first, std::size_t last,
                  double turn_deg) {
  Pose2 before = readings[first - 1].odom_from_robot;
  Pose2 pose = before;
  for (std::size_t i = first; i < readings.size(); ++i) {
    Pose2 step = inverse(before) * readings[i].odom_from_robot;
    before = readings[i].odom_from_robot;
    if (i < last) {
      step.theta_rad += radians(turn_deg) / static_cast<double>(last - first);
      std::fill(readings[i].ranges_m.begin(), readings[i].ranges_m.end(), 0.0F);
    }
    pose = pose * step;
    readings[i].odom_from_robot = pose;
  }
}

TEST(SonarTrajectory, TurnsBackAQuarterThatItTookForTheLikelierWay) {
  DrivenWorld mission = square_corridor(0.0);
  const std::size_t first = mission.readings.size() / 2 + 40;  // on a straight way
  const std::size_t last = first + 60;
  turn_unheard(mission.readings, first, last, 55.0);  // 35 degrees off the other way
  EXPECT_GT(largest_error(mission, odometry_of(mission)).position_m, 5.0);
  SonarTrajectoryOptions once;
  once.repair_slips = false;
  const SonarTrajectory unrepaired =
      correct_sonar_trajectory(mission.readings, find_drive_directions(mission.readings, {}), once);
  EXPECT_GT(largest_error(mission, unrepaired.map_from_robot).heading_deg, 80.0);

  const SonarTrajectory result =
      correct_sonar_trajectory(mission.readings, find_drive_directions(mission.readings, {}), {});
  EXPECT_EQ(result.slips_repaired, 1);
  // nothing tells where it turned until walls were heard for a while
  std::vector<Pose2> heard = result.map_from_robot;
  for (std::size_t i = first - 60; i < last + 30; ++i) heard[i] = mission.truth[i];
  const Error error = largest_error(mission, heard);
  EXPECT_LT(error.position_m, 0.4);
  EXPECT_LT(error.heading_deg, 6.0);
}

/// Two corridors round a corner, each driven to and fro; at the corner nothing is heard while
/// odometry turns half of what the robot does.
DrivenWorld corner_unheard() {
  auto walls = test::walls_along({{0, 0}, {20, 0}, {20, 20}}, false);
  const auto inner = test::walls_along({{0, 1.8}, {18.2, 1.8}, {18.2, 20}}, false);
  walls.insert(walls.end(), inner.begin(), inner.end());
  DrivenWorld mission = drive(
      walls, {{1, 0.9}, {17, 0.9}, {2, 0.9}, {19.1, 0.9}, {19.1, 18}, {19.1, 4}, {19.1, 17}}, 0.0);
  std::size_t turn = 0;  // the last reading on the first corridor
  for (std::size_t i = 0; i < mission.truth.size(); ++i) {
    if (mission.truth[i].y_m < 1.0) turn = i;
  }
  turn_unheard(mission.readings, turn - 30, turn + 30, 45.0);
  return mission;
}

TEST(SonarTrajectory, ATurnThatNothingDecidesHasASecondAnswerAndAClearMissionNone) {
  const DrivenWorld unclear = corner_unheard();
  const DriveDirections directions = find_drive_directions(unclear.readings, {});
  SonarTrajectoryOptions options;
  const SonarTrajectory first = correct_sonar_trajectory(unclear.readings, directions, options);
  ASSERT_TRUE(first.second);
  options.take_second = true;
  const SonarTrajectory second = correct_sonar_trajectory(unclear.readings, directions, options);
  EXPECT_EQ(second.second->name, first.second->name);
  EXPECT_EQ(second.variants.at(second.chosen).name, first.second->name);
  const double apart_rad =
      wrap_angle(first.map_from_robot.back().theta_rad - second.map_from_robot.back().theta_rad);
  EXPECT_GT(std::abs(degrees(apart_rad)), 30.0);

  const DrivenWorld clear = square_corridor(0.0);
  const DriveDirections clear_directions = find_drive_directions(clear.readings, {});
  const SonarTrajectory sure =
      correct_sonar_trajectory(clear.readings, clear_directions, options);  // asked for in vain
  EXPECT_FALSE(sure.second);
  EXPECT_LT(largest_error(clear, sure.map_from_robot).position_m, 0.15);
}

TEST(SonarTrajectory, LeavesTrueOdometryAlone) {
  const DrivenWorld mission = square_corridor(0.0);
  const SonarTrajectory result =
      correct_sonar_trajectory(mission.readings, find_drive_directions(mission.readings, {}), {});
  const Error error = largest_error(mission, result.map_from_robot);
  EXPECT_LT(error.position_m, 0.15);
  EXPECT_LT(error.heading_deg, 2.0);
}

TEST(HeadingsOfReturns, TurnANodeBackThatOdometryLeavesFree) {
  const DrivenWorld mission = square_corridor(0.0);
  const auto directions = find_drive_directions(mission.readings, {});
  const DrivenPath path = driven_path(mission.readings, directions, {});
  SonarProblem problem = sonar_problem(mission.readings, path, mission.truth, {0.0}, {});
  for (DrivenStep& step : problem.batch.steps) step.turn_sigma_rad = 0.5;
  SonarBatchOptions free;
  free.heading_weight = 0.0;
  for (const double off_deg : {-3.0, 3.0}) {
    std::vector<Pose2> nodes = problem.batch.map_from_node;
    const double true_rad = nodes[0].theta_rad;
    nodes[0].theta_rad += radians(off_deg);
    std::vector<Pose2> poses = mission.truth;
    for (std::size_t i = 0; problem.node_of[i] == 0; ++i) poses[i].theta_rad += radians(off_deg);
    const auto turned = with_headings_of_returns(mission.readings, problem, poses, nodes, free);
    EXPECT_NEAR(degrees(turned[0].theta_rad - true_rad), 0.0, 1.0);
  }
}

TEST(SonarTrajectory, DoesNotBendABuildingWithWingsAtAnAngle) {
  for (const double angle_deg : {30.0, 45.0}) {
    const DrivenWorld mission = bent_corridor(angle_deg);
    const SonarTrajectory result =
        correct_sonar_trajectory(mission.readings, find_drive_directions(mission.readings, {}), {});
    const Error error = largest_error(mission, result.map_from_robot);
    EXPECT_LT(error.heading_deg, 5.0) << angle_deg;
    EXPECT_LT(error.position_m, 0.6) << angle_deg;
  }
}

Idea solved_idea(double score_m, double strain, double log_evidence) {
  Idea idea;
  idea.attempt.score_m = score_m;
  idea.attempt.strain = strain;
  idea.heading.log_evidence = log_evidence;
  return idea;
}

TEST(TakesOver, OdometrysHeadingMustMakeUpForWhatWallsSayOfTheirDirection) {
  const Idea best = solved_idea(1600.0, 50.0, 1200.0);
  Idea odometry = solved_idea(1700.0, 50.0, 0.0);
  EXPECT_TRUE(takes_over(odometry, best));
  odometry.is_odometry = true;
  EXPECT_FALSE(takes_over(odometry, best));
  EXPECT_TRUE(takes_over(odometry, solved_idea(1600.0, 50.0, 40.0)));
  odometry.attempt.strain = 120.0;  // more than it gains
  EXPECT_FALSE(takes_over(odometry, solved_idea(1600.0, 50.0, 40.0)));
}

TEST(TakesOver, OpenDirectionsThatStrainOdometryLess) {
  Idea best = solved_idea(740.0, 35.0, 500.0);
  best.directions_rad = {0.0};
  Idea wings = solved_idea(739.0, 14.0, 510.0);
  wings.directions_rad = {0.0, 0.3};
  EXPECT_FALSE(takes_over(wings, best));
  wings.is_open = true;
  EXPECT_TRUE(takes_over(wings, best));
  wings.attempt.strain = 33.0;
  EXPECT_FALSE(takes_over(wings, best));
  wings.attempt.score_m = 790.0;  // false wings: walls gain what odometry does not
  EXPECT_FALSE(takes_over(wings, best));
  wings.attempt.score_m = 739.0;
  best.directions_rad = {0.0, 0.2};  // as many: any gain tells
  EXPECT_TRUE(takes_over(wings, best));
  wings.attempt.strain = 35.0;
  EXPECT_FALSE(takes_over(wings, best));
}

TEST(SonarTrajectory, DoesNotMakeARoundHallSquare) {
  std::vector<Point2> rim;
  std::vector<Point2> way;
  for (int k = 0; k < 72; ++k) rim.push_back(8.0 * direction(radians(5.0 * k)));
  for (int k = 0; k <= 72; ++k) way.push_back(6.5 * direction(radians(10.0 * k)));
  const DrivenWorld mission = drive(test::walls_along(rim, true), way, 0.05);
  const SonarTrajectory result =
      correct_sonar_trajectory(mission.readings, find_drive_directions(mission.readings, {}), {});
  const Error odometry = largest_error(mission, odometry_of(mission));
  const Error error = largest_error(mission, result.map_from_robot);
  EXPECT_LT(error.heading_deg, odometry.heading_deg + 4.0);
  EXPECT_LT(error.position_m, odometry.position_m + 0.5);
}

TEST(SonarTrajectory, IsTheSameEachTime) {
  const DrivenWorld mission = square_corridor(0.6);
  const SonarTrajectory once =
      correct_sonar_trajectory(mission.readings, find_drive_directions(mission.readings, {}), {});
  const SonarTrajectory again =
      correct_sonar_trajectory(mission.readings, find_drive_directions(mission.readings, {}), {});
  EXPECT_EQ(once.map_from_robot, again.map_from_robot);
  EXPECT_EQ(once.habits, again.habits);
}

TEST(SonarTrajectory, OfAnEmptyMissionIsEmpty) {
  const SonarTrajectory result = correct_sonar_trajectory({}, {}, {});
  EXPECT_TRUE(result.map_from_robot.empty());
  EXPECT_FALSE(result.loops_verified);
}

TEST(SonarTrajectory, OfARobotThatStandsIsItsPlace) {
  DrivenWorld mission = square_corridor(0.0);
  mission.readings.resize(30);
  mission.truth.assign(30, mission.truth.front());
  for (RangeReading& reading : mission.readings) {
    reading.odom_from_robot = mission.readings.front().odom_from_robot;
  }
  const SonarTrajectory result =
      correct_sonar_trajectory(mission.readings, find_drive_directions(mission.readings, {}), {});
  ASSERT_EQ(result.map_from_robot.size(), 30U);
  for (const Pose2& pose : result.map_from_robot) ASSERT_TRUE(std::isfinite(pose.theta_rad));
  const Error error = largest_error(mission, result.map_from_robot);
  EXPECT_LT(error.position_m, 1e-6);
  EXPECT_LT(error.heading_deg, 1e-6);
  EXPECT_FALSE(result.loops_verified);
}

TEST(SonarTrajectory, WithoutReturnsIsOdometry) {
  DrivenWorld mission = square_corridor(0.0);
  for (RangeReading& reading : mission.readings) {
    std::fill(reading.ranges_m.begin(), reading.ranges_m.end(), 5.0F);
  }
  const SonarTrajectory result =
      correct_sonar_trajectory(mission.readings, find_drive_directions(mission.readings, {}), {});
  EXPECT_LT(largest_error(mission, result.map_from_robot).position_m, 1e-3);
  EXPECT_FALSE(result.loops_verified);
}

}  // namespace
}  // namespace roomatlas
