// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/compare.hpp"

#include <string>
#include <utility>
#include <vector>

namespace roomatlas {

/// One metric of one run, as evo keeps a result.
struct EvoResult {
  std::string title;
  std::string label;     ///< such as "APE (m)"
  std::string ref_name;  ///< of the trajectories too
  std::string est_name;
  Statistics statistics;
  std::vector<std::pair<std::string, std::vector<double>>> arrays;  ///< "error_array" first
  std::vector<std::pair<std::string, Trajectory>> trajectories;     ///< by name
  bool aligned = false;
  Pose2 truth_from_estimate;  ///< written where `aligned`
};

/// APE with both trajectories, the estimate aligned.
[[nodiscard]] EvoResult evo_ape(const JudgedRun& run, const Comparison& comparison);
/// RPE; the trajectories are cut down to the poses where pairs end, and the first.
[[nodiscard]] EvoResult evo_rpe(const JudgedRun& run, const Comparison& comparison);
/// Translation errors of relations, at the time of each relation's second pose.
[[nodiscard]] EvoResult evo_relations(const JudgedRun& run, const Comparison& comparison);

/// The bytes of a ZIP archive in evo's result layout: info.json, stats.json, NAME.npy for arrays,
/// NAME.tum for trajectories. The same result gives the same bytes.
[[nodiscard]] std::string evo_archive(const EvoResult& result);

}  // namespace roomatlas
