// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/correct/sonar_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "driven_path.hpp"
#include "heading_chain.hpp"
#include "roomatlas/match/contradiction.hpp"
#include "sonar_batch.hpp"
#include "sonar_calibration.hpp"

namespace roomatlas {
namespace {

constexpr double kNodeM = 0.4;
constexpr double kNodeRad = 0.35;
const std::vector<double> kOneDirection = {0.0};

using Readings = std::span<const RangeReading>;

/// Of the chain's corrections, one a reading, those between nodes by way and turn.
struct Headings {
  std::vector<double> turn_rad;
  std::vector<double> sigma_rad;
};

Headings headings_of(const HeadingProblem& problem, const HeadingChain& chain) {
  Headings headings;
  const std::size_t count = problem.path.path_m.size();
  const auto& nodes = problem.node_readings;
  std::size_t node = 0;
  for (std::size_t i = 0; i < count; ++i) {
    while (node + 1 < nodes.size() && nodes[node + 1] <= i) ++node;
    double turn_rad = chain.correction_rad[node];
    if (node + 1 < nodes.size()) {
      const double share = share_between(problem.path, nodes[node], nodes[node + 1], i);
      turn_rad += share * (chain.correction_rad[node + 1] - turn_rad);
    }
    headings.turn_rad.push_back(turn_rad);
    headings.sigma_rad.push_back(chain.sigma_rad[node]);
  }
  return headings;
}

/// The batch and how its nodes stand among the readings.
struct Prepared {
  SonarBatch batch;
  std::vector<std::size_t> node_readings;
  std::vector<std::size_t> node_of;  ///< of each reading: the last one not behind it
  std::vector<WallSegment> segments;
};

DrivenStep step_between(const DrivenPath& path, const std::vector<double>& undecided_m,
                        std::size_t from, std::size_t to) {
  constexpr double kPerSqrtM = 0.03;
  constexpr double kPerRad = 0.02;
  constexpr double kHeadingPerSqrtM = radians(1.0);
  constexpr double kHeadingPerRad = 0.03;
  const double way_m = path.path_m[to] - path.path_m[from];
  const double turn_rad = path.turned_rad[to] - path.turned_rad[from];
  const double across_variance = kPerSqrtM * kPerSqrtM * way_m + 1e-5 +
                                 (kPerRad * turn_rad) * (kPerRad * turn_rad);
  const double either_way_m = undecided_m[to] - undecided_m[from];
  DrivenStep step;
  step.before_from_here = inverse(path.odom_from_robot[from]) * path.odom_from_robot[to];
  step.across_sigma_m = std::sqrt(across_variance);
  step.along_sigma_m = std::sqrt(across_variance + either_way_m * either_way_m);
  step.turn_sigma_rad = std::sqrt(kHeadingPerSqrtM * kHeadingPerSqrtM * way_m +
                                  kHeadingPerRad * kHeadingPerRad * turn_rad * turn_rad + 1e-6);
  return step;
}

Prepared prepare(Readings readings, const DrivenPath& path, const DriveDirections& directions,
                 const std::vector<Pose2>& start, const WallSegmentOptions& options) {
  Prepared prepared;
  prepared.node_readings = nodes_along(path, kNodeM, kNodeRad);
  const auto& nodes = prepared.node_readings;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    prepared.batch.map_from_node.push_back(start[nodes[k]]);
    prepared.batch.steps.push_back(
        k == 0 ? DrivenStep{} : step_between(path, directions.undecided_m, nodes[k - 1], nodes[k]));
  }
  for (std::size_t i = 0, node = 0; i < readings.size(); ++i) {
    if (node + 1 < nodes.size() && nodes[node + 1] <= i) ++node;
    prepared.node_of.push_back(node);
  }
  prepared.segments = wall_segments(readings, start, path.path_m, options);
  for (const WallSegment& segment : prepared.segments) {
    const std::size_t node = prepared.node_of[segment.reading];
    const Pose2 node_from_robot = inverse(path.odom_from_robot[nodes[node]]) *
                                  path.odom_from_robot[segment.reading];
    prepared.batch.walls.push_back({node,
                                    wrap_angle(segment.normal_rad + node_from_robot.theta_rad),
                                    node_from_robot * segment.middle_robot, segment.length_m,
                                    path.path_m[segment.reading]});
    prepared.batch.direction_rad.push_back(0.0);
  }
  return prepared;
}

/// Poses of all readings from those of the nodes: as driven, and what is missing at the next node
/// spread over the way there.
std::vector<Pose2> poses_of(const DrivenPath& path, const Prepared& prepared,
                            const std::vector<Pose2>& map_from_node) {
  const auto& nodes = prepared.node_readings;
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < path.odom_from_robot.size(); ++i) {
    const std::size_t k = prepared.node_of[i];
    const Pose2 node_from_odom = inverse(path.odom_from_robot[nodes[k]]);
    Pose2 pose = map_from_node[k] * (node_from_odom * path.odom_from_robot[i]);
    if (k + 1 < nodes.size()) {
      const Pose2 driven =
          map_from_node[k] * (node_from_odom * path.odom_from_robot[nodes[k + 1]]);
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

/// Moves a trajectory so that it begins where odometry does.
void begin_at(const Pose2& first, std::vector<Pose2>& poses) {
  const Pose2 moved = first * inverse(poses.front());
  for (Pose2& pose : poses) pose = moved * pose;
}

}  // namespace

SonarTrajectory correct_sonar_trajectory(Readings readings, const SonarTrajectoryOptions& options) {
  SonarTrajectory result;
  if (readings.empty()) return result;
  const DriveDirections directions = find_drive_directions(readings, options.directions);
  result.intervals_reversed = directions.intervals_reversed;
  result.undecided_m = directions.undecided_m.back();
  const HeadingChainOptions chain_options;
  if (options.calibrate) {
    result.habits = calibrate_odometry(readings, directions, options.segments, chain_options);
  }
  const HeadingProblem problem =
      heading_problem(readings, directions, result.habits, options.segments);
  const HeadingChain chain =
      smooth_heading(problem.nodes, problem.sightings, kOneDirection, chain_options);
  result.log_evidence = chain.log_evidence;
  const Headings headings = headings_of(problem, chain);
  result.heading_sigma_rad = headings.sigma_rad;
  const std::vector<Pose2> start = with_headings(problem.path, headings.turn_rad);
  const Prepared prepared = prepare(readings, problem.path, directions, start, options.segments);
  result.segments = prepared.segments.size();
  const SonarBatchResult solved = solve_sonar_batch(prepared.batch, {});
  result.map_from_robot = poses_of(problem.path, prepared, solved.map_from_node);
  const Contradiction contradiction = contradiction_of(
      readings, result.map_from_robot, problem.path.path_m, prepared.segments, {});
  result.variants.push_back({"default", result.habits, solved.pairs, contradiction.compared_m(),
                             contradiction.share()});
  begin_at(readings.front().odom_from_robot, result.map_from_robot);
  return result;
}

}  // namespace roomatlas
