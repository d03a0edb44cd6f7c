// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_graph_export.hpp"

#include <cmath>
#include <map>

namespace roomatlas::apps {
namespace {

/// Both visits begin at the same doorway, in the same direction or in the opposite one.
Pose2 shared_doorway(const Pose2& placed) {
  return {0.0, 0.0, std::abs(placed.theta_rad) < kPi / 2.0 ? 0.0 : wrap_angle(kPi)};
}

EdgeKind kind_of(EdgeSource source) {
  return source == EdgeSource::driven ? EdgeKind::odometry : EdgeKind::loop;
}

}  // namespace

PoseGraph pose_graph_of(const RoomGraph& graph, const CorrectOptions& options) {
  PoseGraph result;
  std::map<AsrId, std::int32_t> index_of;
  for (std::size_t i = 0; i < boost::num_vertices(graph); ++i) {
    index_of[graph[i].asr] = static_cast<std::int32_t>(i);
    result.ids.push_back(graph[i].asr);
  }
  for (const PassageEdge& edge : edges_of(graph)) {
    PoseEdge measured;
    measured.from = index_of.at(edge.from);
    measured.to = index_of.at(edge.to);
    measured.kind = kind_of(edge.source);
    measured.information = information_of(edge, options);
    if (measured.information.isZero()) continue;
    measured.from_from_to = edge.source == EdgeSource::recognised
                                ? shared_doorway(edge.from_from_to)
                                : edge.from_from_to;
    result.edges.push_back(measured);
  }
  return result;
}

}  // namespace roomatlas::apps
