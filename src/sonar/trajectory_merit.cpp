// SPDX-License-Identifier: GPL-3.0-or-later
#include "trajectory_merit.hpp"

#include <vector>

#include "driven_path.hpp"
#include "sonar_attempt.hpp"

namespace roomatlas {
namespace {

OdometryHabits habits_of(std::span<const RangeReading> readings, const DriveDirections& directions,
                         std::span<const Pose2> map_from_robot) {
  HabitLearner learner;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    const Pose2 step = inverse(readings[i - 1].odom_from_robot) * readings[i].odom_from_robot;
    learner.add(driven(step, directions.of_step[i]),
                inverse(map_from_robot[i - 1]) * map_from_robot[i], true);
  }
  return learner.habits();
}

}  // namespace

TrajectoryMerit trajectory_merit(std::span<const RangeReading> readings,
                                 const DriveDirections& directions,
                                 std::span<const Pose2> map_from_robot,
                                 const WallSegmentOptions& options, int jobs) {
  TrajectoryMerit merit;
  merit.habits = habits_of(readings, directions, map_from_robot);
  const DrivenPath path = driven_path(readings, directions, merit.habits);
  const std::vector<Pose2> poses(map_from_robot.begin(), map_from_robot.end());
  const SonarProblem problem =
      sonar_problem(readings, path, directions, poses, {0.0}, options, jobs);
  merit.walls_m =
      score_of(contradiction_of(readings, map_from_robot, path.path_m, problem.segments, {}));
  return merit;
}

}  // namespace roomatlas
