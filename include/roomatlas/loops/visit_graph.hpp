// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "roomatlas/correct/correct.hpp"
#include "roomatlas/loops/closures.hpp"
#include "roomatlas/solve/pose_graph.hpp"

namespace roomatlas {

/// The measurements between ASRs as a pose graph, nodes in the order of the graph's vertices: what
/// was driven, doorways that two visits share, and matches of walls.
/// @param closures as the store has them: a match without information there is left out
[[nodiscard]] PoseGraph pose_graph_of(const RoomGraph& graph, const std::vector<Closure>& closures,
                                      const CorrectOptions& options);

/// What holds the visits where a correction puts them.
struct HeldVisits {
  PoseGraph measured;            ///< `pose_graph_of` with the correction's poses as guess, passages
                                 ///< and loops weighed as it believed them, and walls' directions
  double variance_factor = 1.0;  ///< by which the residuals enlarge what was measured
};

/// Of a mission that was corrected as a whole (sonars) only what was driven, doorways and walls'
/// directions, with no weight but their own: the walls that held its path have no measurement here.
[[nodiscard]] HeldVisits held_visits_of(const RoomGraph& graph,
                                        const std::vector<Closure>& closures,
                                        const Correction& correction,
                                        const CorrectOptions& options);

/// Where a visit's frame is, and how sure that is.
struct VisitEstimate {
  AsrId asr = 0;
  Point2 at = Point2::Zero();                               ///< building metres
  Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Zero();  ///< of `at`; building axes
  double heading_sigma_rad = 0.0;
};

/// How sure a correction is of its visits, each relative to the first of its component.
struct VisitUncertainty {
  std::vector<VisitEstimate> visits;  ///< but for the first of each component
  /// Root mean square over the visits of the standard deviation along one axis.
  std::optional<double> typical_m;
  double variance_factor = 1.0;  ///< by which the residuals enlarged what was measured
};

/// From the measurements' own covariances, times what the loops' residuals say of these (chi-square
/// over its degrees of freedom; few loops only ever enlarge), and from the directions of walls.
/// Empty for a mission that was corrected as a whole, for which there are no such measurements,
/// and for a graph without edges.
/// Not guaranteed: errors that all measurements share, such as a scale, are not in it.
[[nodiscard]] VisitUncertainty uncertainty_of(const RoomGraph& graph,
                                              const std::vector<Closure>& closures,
                                              const Correction& correction,
                                              const CorrectOptions& options);

}  // namespace roomatlas
