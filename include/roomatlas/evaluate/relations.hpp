// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/evaluate/pose_lookup.hpp"
#include "roomatlas/evaluate/statistics.hpp"

#include <cstdint>
#include <vector>

namespace roomatlas {

/// The true pose at `t2_s` in the frame of the pose at `t1_s` (Kuemmerle et al., "On measuring
/// the accuracy of SLAM algorithms", Autonomous Robots 2009).
struct Relation {
  double t1_s = 0.0;
  double t2_s = 0.0;
  Pose2 pose1_from_pose2;
};

struct RelationSubset {
  Statistics translation_m;
  Statistics rotation_deg;
};

/// The error at one relation that has a pose at both its times.
struct RelationError {
  std::size_t relation = 0;  ///< its place in the list, from 0
  double t1_s = 0.0;
  double t2_s = 0.0;
  double translation_m = 0.0;  ///< [0, inf)
  double rotation_deg = 0.0;   ///< [0, 180]
  bool is_local = false;
  Pose2 map_from_pose2;  ///< where the trajectory has the robot at `t2_s`
};

struct RelationErrors {
  RelationSubset all;
  RelationSubset local;  ///< |t2 - t1| < split
  RelationSubset loop;
  std::int64_t relations = 0;
  std::int64_t matched = 0;
  std::vector<RelationError> errors;  ///< of the matched ones, in the list's order
  MatchUse use;                       ///< where the poses came from
  Issues issues;                      ///< unmatched relations, counted and the first few named

  /// Share of the relations that the figures cover, [0, 1]; 0 where there are none.
  [[nodiscard]] double coverage() const {
    return relations > 0 ? static_cast<double>(matched) / static_cast<double>(relations) : 0.0;
  }
};

struct RelationOptions {
  double split_s = 30.0;  ///< larger counts more relations as local
  MatchOptions match{};
};

/// Error of a trajectory against relations: of each, the true relative pose against the
/// trajectory's, the translation's length and the rotation's size apart.
/// @param carry odometry that fills the trajectory's gaps; may be null
[[nodiscard]] RelationErrors relation_errors(const Trajectory& trajectory,
                                             const std::vector<Relation>& relations,
                                             const RelationOptions& options,
                                             const Trajectory* carry = nullptr);

}  // namespace roomatlas
