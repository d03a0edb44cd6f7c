// SPDX-License-Identifier: GPL-3.0-or-later
// Whole missions of a sonar ring in small worlds.
#include "roomatlas/correct/sonar_trajectory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../../src/correct/node_headings.hpp"
#include "support/sonar_world.hpp"

namespace roomatlas {
namespace {

struct Mission {
  std::vector<Pose2> truth;
  std::vector<RangeReading> readings;
};

Mission drive(const std::vector<test::WallLine>& walls, const std::vector<Point2>& points,
              double drift_deg_per_m) {
  Mission mission;
  mission.truth = test::drive_along(points);
  mission.readings = test::sonar_readings(walls, mission.truth, drift_deg_per_m);
  return mission;
}

/// Twice round a square corridor, 1.8 m wide.
Mission square_corridor(double drift_deg_per_m) {
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
Error largest_error(const Mission& mission, const std::vector<Pose2>& poses) {
  Error error;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose2 off = inverse(mission.truth[i]) * poses[i];
    error.position_m = std::max(error.position_m, off.position().norm());
    error.heading_deg = std::max(error.heading_deg, std::abs(degrees(off.theta_rad)));
  }
  return error;
}

std::vector<Pose2> odometry_of(const Mission& mission) {
  std::vector<Pose2> poses;
  for (const RangeReading& reading : mission.readings) poses.push_back(reading.odom_from_robot);
  return poses;
}

TEST(SonarTrajectory, TakesADriftOutOfASquareMission) {
  for (const double drift : {-2.5, 0.6}) {
    const Mission mission = square_corridor(drift);
    EXPECT_GT(largest_error(mission, odometry_of(mission)).position_m, 2.0);
    const SonarTrajectory result = correct_sonar_trajectory(mission.readings, {});
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
  Mission mission = square_corridor(0.5);
  turn_by(mission.readings, 0.9);
  EXPECT_GT(largest_error(mission, odometry_of(mission)).heading_deg, 20.0);
  const SonarTrajectory result = correct_sonar_trajectory(mission.readings, {});
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
  Mission mission = square_corridor(0.0);
  const std::size_t first = mission.readings.size() / 2 + 40;  // on a straight way
  const std::size_t last = first + 60;
  turn_unheard(mission.readings, first, last, 55.0);  // 35 degrees off the other way
  EXPECT_GT(largest_error(mission, odometry_of(mission)).position_m, 5.0);
  SonarTrajectoryOptions once;
  once.repair_slips = false;
  const SonarTrajectory unrepaired = correct_sonar_trajectory(mission.readings, once);
  EXPECT_GT(largest_error(mission, unrepaired.map_from_robot).heading_deg, 80.0);

  const SonarTrajectory result = correct_sonar_trajectory(mission.readings, {});
  EXPECT_EQ(result.slips_repaired, 1);
  // nothing tells where it turned until walls were heard for a while
  std::vector<Pose2> heard = result.map_from_robot;
  for (std::size_t i = first - 60; i < last + 30; ++i) heard[i] = mission.truth[i];
  const Error error = largest_error(mission, heard);
  EXPECT_LT(error.position_m, 0.4);
  EXPECT_LT(error.heading_deg, 6.0);
}

TEST(SonarTrajectory, LeavesTrueOdometryAlone) {
  const Mission mission = square_corridor(0.0);
  const SonarTrajectory result = correct_sonar_trajectory(mission.readings, {});
  const Error error = largest_error(mission, result.map_from_robot);
  EXPECT_LT(error.position_m, 0.15);
  EXPECT_LT(error.heading_deg, 2.0);
}

TEST(HeadingsOfReturns, TurnANodeBackThatOdometryLeavesFree) {
  const Mission mission = square_corridor(0.0);
  const auto directions = find_drive_directions(mission.readings, {});
  const DrivenPath path = driven_path(mission.readings, directions, {});
  SonarProblem problem =
      sonar_problem(mission.readings, path, directions, mission.truth, {0.0}, {});
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
      batch.direction_rad.push_back(0.0);
    }
  }
  return batch;
}

TEST(SonarBatch, FindsTheScaleOfOdometrysLengths) {
  for (const double scale : {0.98, 1.0, 1.02}) {
    SonarBatchOptions options;
    options.length_sigma = 0.03;
    const SonarBatchResult result = solve_sonar_batch(to_and_fro(scale), options);
    ASSERT_TRUE(result.solved);
    EXPECT_NEAR(result.length_scale, 1.0 / scale, 0.002);
  }
}

TEST(SonarBatch, StrainsOdometryWhereWallsMoveIt) {
  SonarBatch alone = to_and_fro(1.02);
  alone.walls.clear();
  alone.direction_rad.clear();
  EXPECT_LT(solve_sonar_batch(alone, {}).strain, 1e-9);

  const SonarBatch batch = to_and_fro(1.02);
  SonarBatchOptions options;
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

/// A robot goes round two corridors that lie side by side, three times; odometry is right, but the
/// poses to start from drift aside in the last round, so that the second corridor's walls come to
/// lie nearer to the first's.
struct SideBySide {
  SonarBatch batch;
  std::vector<Pose2> truth;
};

SideBySide side_by_side() {
  constexpr double kStepM = 0.4;
  constexpr double kBetweenM = 2.2;
  constexpr double kToWallM = 0.9;
  constexpr double kAsideM = 1.3;
  constexpr double kDriftM = 20.0;
  SideBySide mission;
  double drifted_m = 0.0;
  const std::vector<Pose2> round =
      test::drive_along({{0, 0}, {20, 0}, {20, kBetweenM}, {0, kBetweenM}, {0, 0}}, kStepM, kPi);
  for (int lap = 0; lap < 3; ++lap) {
    for (const Pose2& at : round) {
      const std::size_t k = mission.truth.size();
      const Pose2 pose{at.x_m, at.y_m, 0.0};  // it drives sideways and backwards, too
      const Pose2 before = k > 0 ? mission.truth.back() : pose;
      const bool is_in_second = pose.y_m > kBetweenM - 0.1;
      mission.truth.push_back(pose);
      SonarBatch& batch = mission.batch;
      const double aside_m = lap == 2 ? kAsideM * std::min(1.0, drifted_m / kDriftM) : 0.0;
      if (lap == 2) drifted_m += kStepM;
      batch.map_from_node.push_back({pose.x_m, pose.y_m - aside_m, 0.0});
      batch.steps.push_back({inverse(before) * pose, 0.02, 0.02, 0.01});
      if (!is_in_second && pose.y_m > 0.1) continue;
      const double corridor_m = is_in_second ? kBetweenM : 0.0;
      for (const double side : {-1.0, 1.0}) {
        const double across_m = corridor_m + side * kToWallM - pose.y_m;
        batch.walls.push_back(
            {k, side * kPi / 2.0, {0.0, across_m}, 1.0, kStepM * static_cast<double>(k)});
        batch.direction_rad.push_back(0.0);
      }
    }
  }
  return mission;
}

TEST(SonarBatch, DoesNotTakeACorridorForTheOneBesideIt) {
  const SideBySide mission = side_by_side();
  const auto largest_m = [&](const SonarBatchOptions& options) {
    const SonarBatchResult result = solve_sonar_batch(mission.batch, options);
    double largest = 0.0;
    for (std::size_t k = 0; k < mission.truth.size(); ++k) {
      largest = std::max(largest,
                         (result.map_from_node[k].position() - mission.truth[k].position()).norm());
    }
    return largest;
  };
  EXPECT_LT(largest_m({}), 0.02);
  SonarBatchOptions at_once;
  at_once.start_wall_weight = at_once.wall_weight;
  EXPECT_GT(largest_m(at_once), 1.5);
}

/// A corridor that goes on at another angle: twice there and back.
Mission bent_corridor(double angle_deg) {
  const Point2 along = direction(radians(angle_deg));
  const Point2 left(-along.y(), along.x());
  const Point2 bend(9.0, 0.0);
  const double shift = 0.9 * std::tan(radians(angle_deg) / 2.0);
  const Point2 outer = bend + Point2(shift, -0.9);
  const Point2 inner = bend + Point2(-shift, 0.9);
  const auto walls = test::walls_along({{-1.0, -0.9},
                                        outer,
                                        bend + 10.0 * along - 0.9 * left,
                                        bend + 10.0 * along + 0.9 * left,
                                        inner,
                                        {-1.0, 0.9}},
                                       true);
  const Point2 end = bend + 9.0 * along;
  return drive(walls, {{0, 0}, bend, end, bend, {0, 0}, bend, end, bend, {0, 0}}, 0.1);
}

TEST(SonarTrajectory, DoesNotBendABuildingWithWingsAtAnAngle) {
  for (const double angle_deg : {30.0, 45.0}) {
    const Mission mission = bent_corridor(angle_deg);
    const SonarTrajectory result = correct_sonar_trajectory(mission.readings, {});
    const Error error = largest_error(mission, result.map_from_robot);
    EXPECT_LT(error.heading_deg, 5.0) << angle_deg;
    EXPECT_LT(error.position_m, 0.6) << angle_deg;
  }
}

TEST(SonarTrajectory, DoesNotMakeARoundHallSquare) {
  std::vector<Point2> rim;
  std::vector<Point2> way;
  for (int k = 0; k < 72; ++k) rim.push_back(8.0 * direction(radians(5.0 * k)));
  for (int k = 0; k <= 72; ++k) way.push_back(6.5 * direction(radians(10.0 * k)));
  const Mission mission = drive(test::walls_along(rim, true), way, 0.05);
  const SonarTrajectory result = correct_sonar_trajectory(mission.readings, {});
  const Error odometry = largest_error(mission, odometry_of(mission));
  const Error error = largest_error(mission, result.map_from_robot);
  EXPECT_LT(error.heading_deg, odometry.heading_deg + 4.0);
  EXPECT_LT(error.position_m, odometry.position_m + 0.5);
}

TEST(SonarTrajectory, IsTheSameEachTime) {
  const Mission mission = square_corridor(0.6);
  const SonarTrajectory once = correct_sonar_trajectory(mission.readings, {});
  const SonarTrajectory again = correct_sonar_trajectory(mission.readings, {});
  EXPECT_EQ(once.map_from_robot, again.map_from_robot);
  EXPECT_EQ(once.habits, again.habits);
}

TEST(SonarTrajectory, OfAnEmptyMissionIsEmpty) {
  const SonarTrajectory result = correct_sonar_trajectory({}, {});
  EXPECT_TRUE(result.map_from_robot.empty());
  EXPECT_FALSE(result.loops_verified);
}

TEST(SonarTrajectory, OfARobotThatStandsIsItsPlace) {
  Mission mission = square_corridor(0.0);
  mission.readings.resize(30);
  mission.truth.assign(30, mission.truth.front());
  for (RangeReading& reading : mission.readings) {
    reading.odom_from_robot = mission.readings.front().odom_from_robot;
  }
  const SonarTrajectory result = correct_sonar_trajectory(mission.readings, {});
  ASSERT_EQ(result.map_from_robot.size(), 30U);
  for (const Pose2& pose : result.map_from_robot) ASSERT_TRUE(std::isfinite(pose.theta_rad));
  const Error error = largest_error(mission, result.map_from_robot);
  EXPECT_LT(error.position_m, 1e-6);
  EXPECT_LT(error.heading_deg, 1e-6);
  EXPECT_FALSE(result.loops_verified);
}

TEST(SonarTrajectory, WithoutReturnsIsOdometry) {
  Mission mission = square_corridor(0.0);
  for (RangeReading& reading : mission.readings) {
    std::fill(reading.ranges_m.begin(), reading.ranges_m.end(), 5.0F);
  }
  const SonarTrajectory result = correct_sonar_trajectory(mission.readings, {});
  EXPECT_LT(largest_error(mission, result.map_from_robot).position_m, 1e-3);
  EXPECT_FALSE(result.loops_verified);
}

}  // namespace
}  // namespace roomatlas
