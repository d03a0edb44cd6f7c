// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include "roomatlas/core/rigid_fit.hpp"
#include "roomatlas/evaluate/pose_lookup.hpp"
#include "roomatlas/evaluate/true_poses.hpp"

namespace roomatlas {
namespace {

/// A pose of the trajectory and the true pose at its time.
struct PosePair {
  double timestamp_s = 0.0;
  Pose2 building_from_robot;
  Pose2 truth_from_robot;
};

std::vector<PosePair> matched(const Trajectory& trajectory, const Trajectory& truth) {
  std::vector<PosePair> pairs;
  PoseLookup true_pose(truth, {.match = TimeMatch::interpolate});
  for (const auto& [timestamp_s, building_from_robot] : trajectory) {
    if (const auto found = true_pose.next(timestamp_s)) {
      pairs.push_back({timestamp_s, building_from_robot, found->pose});
    }
  }
  return pairs;
}

Pose2 least_squares_alignment(const std::vector<PosePair>& pairs) {
  std::vector<PointPair> points;
  points.reserve(pairs.size());
  for (const PosePair& pair : pairs) {
    points.push_back({pair.building_from_robot.position(), pair.truth_from_robot.position()});
  }
  return rigid_fit(points);
}

PlacedPoseErrors errors_at(const std::vector<PosePair>& pairs, const Pose2& truth_from_building) {
  std::vector<double> position_m;
  std::vector<double> heading_deg;
  for (const PosePair& pair : pairs) {
    const Pose2 error =
        inverse(pair.truth_from_robot) * (truth_from_building * pair.building_from_robot);
    position_m.push_back(error.position().norm());
    heading_deg.push_back(degrees(std::abs(error.theta_rad)));
  }
  return {statistics(std::move(position_m)), statistics(std::move(heading_deg))};
}

}  // namespace

PlacedPoseErrors placed_pose_errors(const Trajectory& trajectory, const Trajectory& truth,
                                    const Pose2& truth_from_building) {
  return errors_at(matched(trajectory, truth), truth_from_building);
}

TruePoseErrors true_pose_errors(const Trajectory& trajectory, const Trajectory& truth) {
  TruePoseErrors result;
  result.poses = std::ssize(trajectory);
  const std::vector<PosePair> pairs = matched(trajectory, truth);
  result.matched = std::ssize(pairs);
  if (pairs.empty()) return result;
  const Pose2 aligned_at_first =
      pairs.front().truth_from_robot * inverse(pairs.front().building_from_robot);
  std::vector<double> position_m;
  std::vector<double> heading_deg;
  for (const auto& [timestamp_s, building_from_robot, truth_from_robot] : pairs) {
    const Pose2 error = inverse(truth_from_robot) * (aligned_at_first * building_from_robot);
    position_m.push_back(error.position().norm());
    result.errors.push_back({timestamp_s, position_m.back()});
    heading_deg.push_back(degrees(std::abs(error.theta_rad)));
  }
  result.position_m = statistics(std::move(position_m));
  result.heading_deg = statistics(std::move(heading_deg));
  result.truth_from_building = least_squares_alignment(pairs);
  std::vector<double> fitted_m;
  for (const PosePair& pair : pairs) {
    const Point2 at = result.truth_from_building * pair.building_from_robot.position();
    fitted_m.push_back((at - pair.truth_from_robot.position()).norm());
  }
  result.fitted_position_m = statistics(std::move(fitted_m));
  return result;
}

}  // namespace roomatlas
