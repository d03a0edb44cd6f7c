// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_problem.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "map_directions.hpp"
#include "roomatlas/odometry/noise.hpp"
#include "wall_stretches.hpp"

namespace roomatlas {
namespace {

// Nodes of the batch: farther apart, walls bend between them; nearer costs time alone.
constexpr double kNodeM = 0.4;
constexpr double kNodeRad = 0.35;

/// Over the way between two nodes: 3 cm/sqrt(m), 2 cm a radian and 3 mm; 1 degree/sqrt(m), 3 % of
/// the turn and 0.06 degrees. Less than over a room, since what is left of the bias has not added
/// up yet, and less of the heading than in its chain, since robust: what does not fit loses weight.
constexpr OdometryNoise kStepNoise{
    .position = {.still = 0.0031622776601683794, .per_sqrt_m = 0.03, .per_rad = 0.02},
    .heading = {.still = 0.001, .per_sqrt_m = radians(1.0), .per_rad = 0.03}};

using Readings = std::span<const RangeReading>;

/// The parts are independent. Their squares are written out and not left to `sum_of_squares`: the
/// last digits of poses hang on the order in which they are added.
DrivenStep step_between(const DrivenPath& path, std::size_t from, std::size_t to) {
  const MotionSigma& position = kStepNoise.position;
  const MotionSigma& heading = kStepNoise.heading;
  const double way_m = path.path_m[to] - path.path_m[from];
  const double turn_rad = path.turned_rad[to] - path.turned_rad[from];
  const double across_variance = position.per_sqrt_m * position.per_sqrt_m * way_m +
                                 position.still * position.still +
                                 (position.per_rad * turn_rad) * (position.per_rad * turn_rad);
  const double either_way_m = path.undecided_m[to] - path.undecided_m[from];
  DrivenStep step;
  step.before_from_here = inverse(path.odom_from_robot[from]) * path.odom_from_robot[to];
  step.across_sigma_m = std::sqrt(across_variance);
  step.along_sigma_m = std::sqrt(across_variance + either_way_m * either_way_m);
  step.turn_sigma_rad = std::sqrt(heading.per_sqrt_m * heading.per_sqrt_m * way_m +
                                  heading.per_rad * heading.per_rad * turn_rad * turn_rad +
                                  heading.still * heading.still);
  return step;
}

/// Readings of each ring that are some way apart, or of each sonar where it is a sensor of its own.
struct SonarReadings {
  std::vector<std::size_t> apart;
  std::size_t sonars = 0;  ///< of all rings together
};
SonarReadings sonar_readings(Readings readings, const DrivenPath& path) {
  constexpr double kApartM = 0.08;
  constexpr double kApartRad = 0.08;
  SonarReadings result;
  std::map<const RangeSensor*, std::size_t> last;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const RangeSensor& sensor = *readings[i].sensor;
    if (sensor.kind != SensorKind::sonar) continue;
    const auto [before, is_first] = last.try_emplace(&sensor, i);
    if (is_first) {
      result.sonars += sensor.robot_from_beam.size();
    } else if (path.path_m[i] - path.path_m[before->second] <= kApartM &&
               path.turned_rad[i] - path.turned_rad[before->second] <= kApartRad) {
      continue;
    }
    before->second = i;
    result.apart.push_back(i);
  }
  return result;
}

}  // namespace

SonarProblem sonar_problem(Readings readings, const DrivenPath& path,
                           const std::vector<Pose2>& start,
                           const std::vector<double>& directions_rad,
                           const WallSegmentOptions& options, int jobs) {
  SonarProblem problem;
  problem.node_readings = nodes_along(path, kNodeM, kNodeRad);
  const auto& nodes = problem.node_readings;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    problem.batch.map_from_node.push_back(start[nodes[k]]);
    problem.batch.steps.push_back(k == 0 ? DrivenStep{}
                                         : step_between(path, nodes[k - 1], nodes[k]));
  }
  for (std::size_t i = 0, node = 0; i < readings.size(); ++i) {
    if (node + 1 < nodes.size() && nodes[node + 1] <= i) ++node;
    problem.node_of.push_back(node);
  }
  problem.segments = wall_segments(readings, start, path.path_m, options, jobs);
  std::vector<MapWall> on_map;
  on_map.reserve(problem.segments.size());
  problem.batch.directions_rad = directions_rad;
  for (const WallSegment& segment : problem.segments) {
    const double normal_rad = start[segment.reading].theta_rad + segment.normal_rad;
    const std::size_t node = problem.node_of[segment.reading];
    const Pose2 node_from_robot =
        inverse(path.odom_from_robot[nodes[node]]) * path.odom_from_robot[segment.reading];
    problem.batch.walls.push_back({node, wrap_angle(segment.normal_rad + node_from_robot.theta_rad),
                                   node_from_robot * segment.middle_robot, segment.length_m,
                                   path.path_m[segment.reading], segment.sigma_m});
    on_map.push_back({normal_rad, segment.length_m});
  }
  const std::vector<std::size_t> followed = directions_followed(on_map, directions_rad);
  for (std::size_t i = 0; i < followed.size(); ++i) {
    problem.batch.walls[i].direction = followed[i];
  }
  return problem;
}

std::vector<SeenReturn> seen_returns(std::span<const RangeReading> readings, const DrivenPath& path,
                                     const SonarProblem& problem) {
  const SonarReadings heard = sonar_readings(readings, path);
  const double share = 1.0 / static_cast<double>(std::max<std::size_t>(1, heard.sonars));
  std::vector<SeenReturn> returns;
  for (const std::size_t i : heard.apart) {
    const RangeSensor& sensor = *readings[i].sensor;
    const std::size_t node = problem.node_of[i];
    const Pose2 node_from_robot =
        inverse(path.odom_from_robot[problem.node_readings[node]]) * path.odom_from_robot[i];
    for (std::size_t beam = 0; beam < sensor.robot_from_beam.size(); ++beam) {
      const double range_m = readings[i].ranges_m[beam];
      if (!tells_of_walls(range_m, sensor)) continue;
      returns.push_back({node, node_from_robot * sensor.robot_from_beam[beam], range_m,
                         sensor.half_cone_rad, path.path_m[i], share});
    }
  }
  return returns;
}

std::vector<Pose2> poses_of(const DrivenPath& path, const SonarProblem& problem,
                            const std::vector<Pose2>& map_from_node) {
  const auto& nodes = problem.node_readings;
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < path.odom_from_robot.size(); ++i) {
    const std::size_t k = problem.node_of[i];
    const Pose2 node_from_odom = inverse(path.odom_from_robot[nodes[k]]);
    Pose2 pose = map_from_node[k] * (node_from_odom * path.odom_from_robot[i]);
    if (k + 1 < nodes.size()) {
      const Pose2 driven = map_from_node[k] * (node_from_odom * path.odom_from_robot[nodes[k + 1]]);
      const double share = share_between(path, nodes[k], nodes[k + 1], i);
      const Pose2& next = map_from_node[k + 1];
      pose.x_m += share * (next.x_m - driven.x_m);
      pose.y_m += share * (next.y_m - driven.y_m);
      pose.theta_rad =
          wrap_angle(pose.theta_rad + share * wrap_angle(next.theta_rad - driven.theta_rad));
    }
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace roomatlas
