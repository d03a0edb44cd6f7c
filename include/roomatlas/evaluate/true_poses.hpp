// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/evaluate/statistics.hpp"

#include <cstdint>
#include <vector>

namespace roomatlas {

/// Of one pose, aligned at the first.
struct TruePoseError {
  double timestamp_s = 0.0;
  double position_m = 0.0;
};

/// Error of a trajectory against true poses, aligned at the first matched pose. True poses are
/// interpolated between their neighbours in file order; poses outside them are not matched.
struct TruePoseErrors {
  Statistics position_m;
  Statistics heading_deg;
  Statistics fitted_position_m;  ///< aligned by least squares: the map's shape without the heading
                                 ///< of its first pose
  std::vector<TruePoseError> errors;  ///< in the order of the trajectory
  std::int64_t poses = 0;
  std::int64_t matched = 0;
  Pose2 truth_from_building;  ///< the least-squares alignment of all matched positions, for
                              ///< comparing plans
};
[[nodiscard]] TruePoseErrors true_pose_errors(const Trajectory& trajectory,
                                              const Trajectory& truth);

/// Errors in a frame that is known, without any alignment.
struct PlacedPoseErrors {
  Statistics position_m;
  Statistics heading_deg;
};
[[nodiscard]] PlacedPoseErrors placed_pose_errors(const Trajectory& trajectory,
                                                  const Trajectory& truth,
                                                  const Pose2& truth_from_building);

}  // namespace roomatlas
