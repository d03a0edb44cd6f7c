// SPDX-License-Identifier: GPL-3.0-or-later
#include "driven_path.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

/// Odometry's pose at another time than a reading's, between the readings around it in the file.
Pose2 pose_at(std::span<const RangeReading> readings, std::size_t reading, double timestamp_s) {
  std::size_t before = reading;
  while (before > 0 && readings[before].timestamp_s > timestamp_s) --before;
  while (before + 2 < readings.size() && readings[before + 1].timestamp_s <= timestamp_s) ++before;
  if (before + 1 >= readings.size()) return readings[reading].odom_from_robot;
  const RangeReading& from = readings[before];
  const RangeReading& to = readings[before + 1];
  const double span_s = to.timestamp_s - from.timestamp_s;
  if (!(span_s > 0.0)) return readings[reading].odom_from_robot;
  const double share = std::clamp((timestamp_s - from.timestamp_s) / span_s, 0.0, 1.0);
  const Pose2 step = inverse(from.odom_from_robot) * to.odom_from_robot;
  return from.odom_from_robot * Pose2{share * step.x_m, share * step.y_m, share * step.theta_rad};
}

}  // namespace

DrivenPath driven_path(std::span<const RangeReading> readings, const DriveDirections& directions,
                       const OdometryHabits& habits) {
  DrivenPath path;
  path.undecided_m = directions.undecided_m;
  Pose2 reported_before;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const Pose2 reported = habits.lag_s == 0.0
                               ? readings[i].odom_from_robot
                               : pose_at(readings, i, readings[i].timestamp_s + habits.lag_s);
    if (i == 0) {
      path.odom_from_robot.push_back(readings[i].odom_from_robot);
      path.path_m.push_back(0.0);
      path.turned_rad.push_back(0.0);
    } else {
      Pose2 step = inverse(reported_before) * reported;
      const double length_m = step.position().norm();
      step = without_habits(driven(step, directions.of_step[i]), habits);
      path.odom_from_robot.push_back(path.odom_from_robot.back() * step);
      path.path_m.push_back(path.path_m.back() + length_m);
      path.turned_rad.push_back(path.turned_rad.back() + std::abs(step.theta_rad));
    }
    reported_before = reported;
  }
  return path;
}

OdometryHabits habits_between(std::span<const Pose2> odom_from_robot,
                              std::span<const Pose2> map_from_robot, bool are_lengths_seen) {
  HabitLearner learner;
  for (std::size_t i = 1; i < odom_from_robot.size(); ++i) {
    learner.add(inverse(odom_from_robot[i - 1]) * odom_from_robot[i],
                inverse(map_from_robot[i - 1]) * map_from_robot[i], are_lengths_seen);
  }
  return learner.habits();
}

std::vector<Pose2> with_headings(const DrivenPath& path, std::span<const double> turn_rad) {
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < path.odom_from_robot.size(); ++i) {
    if (i == 0) {
      Pose2 first = path.odom_from_robot.front();
      first.theta_rad = wrap_angle(first.theta_rad + turn_rad[0]);
      poses.push_back(first);
      continue;
    }
    Pose2 step = inverse(path.odom_from_robot[i - 1]) * path.odom_from_robot[i];
    const double more_rad = turn_rad[i] - turn_rad[i - 1];
    const Pose2 half_turned = Pose2{0.0, 0.0, more_rad / 2.0} * step;
    step = {half_turned.x_m, half_turned.y_m, step.theta_rad + more_rad};
    poses.push_back(poses.back() * step);
  }
  return poses;
}

std::vector<std::size_t> nodes_along(const DrivenPath& path, double step_m, double turn_rad) {
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < path.path_m.size(); ++i) {
    if (nodes.empty() || path.path_m[i] - path.path_m[nodes.back()] > step_m ||
        path.turned_rad[i] - path.turned_rad[nodes.back()] > turn_rad) {
      nodes.push_back(i);
    }
  }
  return nodes;
}

double share_between(const DrivenPath& path, std::size_t from, std::size_t to,
                     std::size_t reading) {
  constexpr double kMetresPerRad = 0.3;  // a turn counts as so much way: else what is missing after
                                         // a turn on the spot would jump there
  const auto way = [&](std::size_t until) {
    return path.path_m[until] - path.path_m[from] +
           kMetresPerRad * (path.turned_rad[until] - path.turned_rad[from]);
  };
  const double whole = way(to);
  constexpr double kNoWayM = 1e-9;  // nothing moved: no share
  return whole > kNoWayM ? way(reading) / whole : 0.0;
}

}  // namespace roomatlas
