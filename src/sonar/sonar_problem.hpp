// SPDX-License-Identifier: GPL-3.0-or-later
// A sonar mission as the batch sees it, and back.
#pragma once

#include <span>
#include <vector>

#include "driven_path.hpp"
#include "sonar_batch.hpp"

namespace roomatlas {

/// The batch and how its nodes stand among the readings.
struct SonarProblem {
  SonarBatch batch;
  std::vector<std::size_t> node_readings;
  std::vector<std::size_t> node_of;  ///< of each reading: the last one not behind it
  std::vector<WallSegment> segments;
};

/// @param start poses to extract the walls at and to start from, one a reading
/// @param directions_rad of the building's walls, modulo 90 degrees: each wall is held to follow
///   the nearest
/// @param jobs threads at once, see `for_each_index`
[[nodiscard]] SonarProblem sonar_problem(std::span<const RangeReading> readings,
                                         const DrivenPath& path, const std::vector<Pose2>& start,
                                         const std::vector<double>& directions_rad,
                                         const WallSegmentOptions& options, int jobs = 1);

/// The returns of readings that are some way apart, of each sensor by itself: nearer ones hear the
/// same noise again.
[[nodiscard]] std::vector<SeenReturn> seen_returns(std::span<const RangeReading> readings,
                                                   const DrivenPath& path,
                                                   const SonarProblem& problem);

/// Poses of all readings from those of the nodes: as driven, and what is missing at the next node
/// spread over the way there.
[[nodiscard]] std::vector<Pose2> poses_of(const DrivenPath& path, const SonarProblem& problem,
                                          const std::vector<Pose2>& map_from_node);

}  // namespace roomatlas
