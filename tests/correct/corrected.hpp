// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the correction share.
#pragma once

#include "roomatlas/correct/correct.hpp"
#include "support/chain_mission.hpp"

namespace roomatlas::test {

inline CorrectOptions options_of(CorrectionModel model) {
  CorrectOptions options;
  options.model = model;
  return options;
}

/// Corrects with the driven edges and those that the test adds.
inline Correction corrected(const std::vector<Asr>& asrs, const CorrectOptions& options,
                            const std::vector<PassageEdge>& more_edges = {}) {
  RoomGraph graph = build_graph(asrs);
  for (const PassageEdge& edge : more_edges) add_edge(graph, edge);
  return correct(asrs, graph, options);
}

struct LargestError {
  double position_m = 0.0;
  double heading_deg = 0.0;
};

/// Of any ASR's pose as seen from the first, so that where the building lies does not count.
inline LargestError largest_error(const Placement& placement, const Placement& truth) {
  LargestError largest;
  const Pose2 found_from_true = placement.begin()->second * inverse(truth.begin()->second);
  for (const auto& [id, true_pose] : truth) {
    const Pose2 off = inverse(found_from_true * true_pose) * placement.at(id);
    largest.position_m = std::max(largest.position_m, off.position().norm());
    largest.heading_deg = std::max(largest.heading_deg, std::abs(degrees(off.theta_rad)));
  }
  return largest;
}

inline Placement odometry_placement(const std::vector<Asr>& asrs) {
  Placement placement;
  for (const Asr& asr : asrs) placement[asr.id] = asr.odom_from_asr;
  return placement;
}

}  // namespace roomatlas::test
