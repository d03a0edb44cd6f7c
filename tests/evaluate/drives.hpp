// SPDX-License-Identifier: GPL-3.0-or-later
// Drives for the tests of trajectories.
#pragma once

#include "roomatlas/evaluate/alignment.hpp"

#include <cmath>
#include <random>

namespace roomatlas::test {

/// A drive with bends, a pose every 0.25 s.
inline Trajectory bent(std::size_t poses, double start_s = 100.0) {
  Trajectory drive;
  for (std::size_t i = 0; i < poses; ++i) {
    const double s = 0.1 * static_cast<double>(i);
    drive.push_back({start_s + 0.25 * static_cast<double>(i),
                     {s, 2.0 * std::sin(0.7 * s), wrap_angle(0.9 * s)}});
  }
  return drive;
}

/// The same drive as someone else would have it: in another frame, with noise.
inline Trajectory disturbed(Trajectory drive, double noise, const Pose2& other_from_frame) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;  // no noise is no distribution
  for (StampedPose& stamped : drive) {
    stamped.pose = other_from_frame * stamped.pose *
                   Pose2{noise * normal(random), noise * normal(random), noise * normal(random)};
  }
  return drive;
}

inline MatchedPoses matched_drives(std::size_t poses, double noise = 0.05) {
  const Trajectory truth = bent(poses);
  return match_poses(disturbed(truth, noise, {4.0, -7.0, 2.2}), truth, {});
}

}  // namespace roomatlas::test
