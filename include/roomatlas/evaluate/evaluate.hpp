// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/evaluate/plan_errors.hpp"
#include "roomatlas/merge/floor_plan.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace roomatlas {

/// The true pose at `t2_s` in the frame of the pose at `t1_s` (Kuemmerle et al., "On measuring
/// the accuracy of SLAM algorithms", Autonomous Robots 2009).
struct Relation {
  double t1_s = 0.0;
  double t2_s = 0.0;
  Pose2 pose1_from_pose2;
};

/// Statistics of absolute values. `count` 0 means that there was nothing to measure; the rest is
/// then NaN.
struct Statistics {
  std::int64_t count = 0;
  double mean = std::numeric_limits<double>::quiet_NaN();
  double standard_deviation = std::numeric_limits<double>::quiet_NaN();  ///< of the population
  double median = std::numeric_limits<double>::quiet_NaN();  ///< even count: mean of the middle two
  double maximum = std::numeric_limits<double>::quiet_NaN();
};

/// The values' absolute values in short; the order of the values does not matter, to the last
/// bit. A NaN among them makes everything but the count NaN: a broken measurement shows.
[[nodiscard]] Statistics statistics(std::vector<double> values);

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

/// Error of a trajectory against true poses, aligned at the first matched pose. True poses are
/// interpolated between their neighbours in file order; poses outside them are not matched.
struct TruePoseErrors {
  Statistics position_m;
  Statistics heading_deg;
  std::int64_t poses = 0;
  std::int64_t matched = 0;
  Pose2 truth_from_building;  ///< the least-squares alignment of all matched positions, for
                              ///< comparing plans; the errors above are aligned at the first
};
[[nodiscard]] TruePoseErrors true_pose_errors(const Trajectory& trajectory,
                                              const Trajectory& truth);

}  // namespace roomatlas
