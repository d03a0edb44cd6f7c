// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/pose2.hpp"
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

struct RelationErrors {
  RelationSubset all;
  RelationSubset local;  ///< |t2 - t1| < split
  RelationSubset loop;
  std::int64_t relations = 0;
  std::int64_t matched = 0;
  Issues issues;  ///< unmatched relations, counted and the first few named
};

struct RelationOptions {
  double split_s = 30.0;  ///< larger counts more relations as local
};

/// Error of a trajectory against relations. Timestamps match exactly (to half a microsecond,
/// which is what the files' six decimals carry). Where a timestamp occurs twice, the first holds.
[[nodiscard]] RelationErrors relation_errors(const Trajectory& trajectory,
                                             const std::vector<Relation>& relations,
                                             const RelationOptions& options);

}  // namespace roomatlas
