// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/correct/correct.hpp"
#include "roomatlas/correct/pose_graph.hpp"

namespace roomatlas::apps {

/// The measurements between ASRs as a pose graph, nodes in the order of the graph's vertices: what
/// was driven, and doorways that two visits share. Matches of walls are left out unless the graph
/// has their information.
[[nodiscard]] PoseGraph pose_graph_of(const RoomGraph& graph, const CorrectOptions& options);

}  // namespace roomatlas::apps
