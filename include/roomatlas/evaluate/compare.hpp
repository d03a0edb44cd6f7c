// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/issue.hpp"
#include "roomatlas/evaluate/ape_rpe.hpp"
#include "roomatlas/evaluate/bootstrap.hpp"
#include "roomatlas/evaluate/relations.hpp"

#include <optional>
#include <string>
#include <vector>

namespace roomatlas {

/// A trajectory that is judged. Its clock is the truth's already (`restamp`, `shifted`).
struct Run {
  std::string name;
  Trajectory trajectory;
  /// Its own true poses, as a simulated mission has them; used where the common truth has none.
  Trajectory truth = {};
  std::vector<Relation> relations = {};  ///< its own, instead of the common ones
};

/// What all trajectories are judged against; either may be empty.
struct TrajectoryTruth {
  std::string name;
  std::vector<Relation> relations;
  Trajectory poses;
};

struct CompareOptions {
  MatchOptions match;     ///< for all three metrics
  double split_s = 30.0;  ///< relations across less are local ones; see `relation_errors`
  ApeOptions ape;
  RpeOptions rpe;
  BootstrapOptions bootstrap;
};

/// One list of errors with its unit, statistics and the interval of its mean.
struct JudgedErrors {
  Statistics statistics;
  ConfidenceInterval interval;
  /// Mean of (this run less the first run) over what both cover; nothing for the first run, nor for
  /// a run with other true poses, which is another mission.
  std::optional<ConfidenceInterval> against_first;
  std::int64_t shared = 0;  ///< how many errors both have
};

struct JudgedRelations {
  RelationErrors errors;
  JudgedErrors translation_m;
  JudgedErrors rotation_deg;
};

struct JudgedPoses {
  MatchedPoses matched;
  PoseErrors ape;
  PoseErrors rpe;
  JudgedErrors ape_judged;
  JudgedErrors rpe_judged;
};

struct JudgedRun {
  std::string name;
  std::int64_t poses = 0;
  std::int64_t truth_poses = 0;  ///< that it was judged by
  std::optional<JudgedRelations> relations;
  std::optional<JudgedPoses> true_poses;
  Issues issues;
};

struct Comparison {
  std::string truth;
  CompareOptions options;
  bool carried = false;         ///< gaps were filled by odometry
  std::int64_t relations = 0;   ///< of the truth
  std::int64_t true_poses = 0;  ///< of the truth; of the first run with its own where that has none
  std::vector<JudgedRun> runs;

  /// Whether any run has a figure.
  [[nodiscard]] bool has_figures() const;
};

/// Judges runs against one truth, side by side. Whatever a run does not cover is left out of its
/// figures and counted; differences are taken over what both runs cover.
/// @param carry odometry that fills the runs' gaps; may be null
[[nodiscard]] Comparison compare(const std::vector<Run>& runs, const TrajectoryTruth& truth,
                                 const CompareOptions& options, const Trajectory* carry = nullptr);

/// What was used to bring times together, for people: "times matched exactly", "poses
/// interpolated linearly, gaps of any length", "... and carried by odometry beyond".
[[nodiscard]] std::string describe(const MatchOptions& options, bool carried);

}  // namespace roomatlas
