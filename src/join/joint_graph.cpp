// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_graph.hpp"

#include <algorithm>
#include <map>

#include "roomatlas/solve/optimize.hpp"

namespace roomatlas {
namespace {

Eigen::Matrix3d information_of(const OwnSigmas& sigmas, double apart_m) {
  const double position_m = sigmas.position_m + sigmas.position_m_per_m * apart_m;
  const double heading_rad = radians(sigmas.heading_deg);
  Eigen::Vector3d weights;
  weights << 1.0 / (position_m * position_m), 1.0 / (position_m * position_m),
      1.0 / (heading_rad * heading_rad);
  return weights.asDiagonal();
}

/// A mission's own correction as measurements between its visits: each against the one before, and
/// against the nearest of the earlier ones, so that it bends as a sheet does and not as a chain.
class OwnMeasurements {
 public:
  OwnMeasurements(const MissionMap& mission, const JoinOptions& options)
      : mission_(mission),
        sigmas_(mission.sensor == SensorKind::laser ? options.laser : options.sonar),
        robust_sigmas_(options.robust_sigmas),
        own_heading_rad_(radians(options.own_heading_deg)),
        neighbours_(static_cast<std::size_t>(std::max(0, options.own_neighbours))) {}

  void add_to(PoseGraph& graph, const std::map<AsrId, std::int32_t>& node_of) const {
    for (const OwnMeasurement& one : mission_.measured) {
      graph.edges.push_back({node_of.at(one.from), node_of.at(one.to),
                             one.is_closure ? EdgeKind::loop : EdgeKind::odometry, one.from_from_to,
                             one.information, one.is_closure ? robust_sigmas_ : 0.0});
    }
    if (!mission_.measured.empty()) {
      add_headings_to(graph, node_of);
      return;
    }
    for (std::size_t i = 1; i < mission_.shapes.size(); ++i) {
      for (const std::size_t earlier : held_to(i)) {
        const Pose2 between = inverse(pose(earlier)) * pose(i);
        graph.edges.push_back({node_of.at(mission_.shapes[earlier].id),
                               node_of.at(mission_.shapes[i].id), EdgeKind::odometry, between,
                               information_of(sigmas_, between.position().norm()), 0.0});
      }
    }
  }

 private:
  /// The heading of each visit against the first, as the mission's correction has it: it knew the
  /// directions of walls, without which a long corridor that leads away from the others bends.
  void add_headings_to(PoseGraph& graph, const std::map<AsrId, std::int32_t>& node_of) const {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    information(2, 2) = 1.0 / (own_heading_rad_ * own_heading_rad_);
    for (std::size_t i = 1; i < mission_.shapes.size(); ++i) {
      graph.edges.push_back({node_of.at(mission_.shapes[0].id), node_of.at(mission_.shapes[i].id),
                             EdgeKind::odometry, inverse(pose(0)) * pose(i), information,
                             robust_sigmas_});
    }
  }

  [[nodiscard]] const Pose2& pose(std::size_t i) const {
    return mission_.mission_from_asr.at(mission_.shapes[i].id);
  }

  [[nodiscard]] std::vector<std::size_t> held_to(std::size_t i) const {
    std::vector<std::size_t> earlier;
    for (std::size_t k = 0; k + 1 < i; ++k) earlier.push_back(k);
    const std::size_t count = std::min(neighbours_, earlier.size());
    std::partial_sort(earlier.begin(), earlier.begin() + static_cast<std::ptrdiff_t>(count),
                      earlier.end(), [&](std::size_t a, std::size_t b) {
                        const double a_m = (pose(a).position() - pose(i).position()).norm();
                        const double b_m = (pose(b).position() - pose(i).position()).norm();
                        return a_m != b_m ? a_m < b_m : a < b;
                      });
    earlier.resize(count);
    earlier.push_back(i - 1);
    return earlier;
  }

  const MissionMap& mission_;
  const OwnSigmas& sigmas_;
  double robust_sigmas_;
  double own_heading_rad_;
  std::size_t neighbours_;
};

}  // namespace

void solve_joint(const std::vector<const MissionMap*>& missions, const JoinOptions& options,
                 Placement& placement, std::vector<Closure>& closures) {
  PoseGraph graph;
  std::map<AsrId, std::int32_t> node_of;
  for (const MissionMap* mission : missions) {
    for (const AsrShape& shape : mission->shapes) {
      node_of[shape.id] = static_cast<std::int32_t>(graph.ids.size());
      graph.ids.push_back(shape.id);
      graph.guess.push_back(placement.at(shape.id));
    }
  }
  for (const MissionMap* mission : missions)
    OwnMeasurements(*mission, options).add_to(graph, node_of);
  std::vector<std::size_t> closure_of_edge;
  const std::size_t first = graph.edges.size();
  for (std::size_t k = 0; k < closures.size(); ++k) {
    const Closure& closure = closures[k];
    if (closure.verdict != ClosureVerdict::accepted || !node_of.contains(closure.from)) continue;
    closure_of_edge.push_back(k);
    graph.edges.push_back({node_of.at(closure.from), node_of.at(closure.to), EdgeKind::loop,
                           closure.match.first_from_second, closure.match.information,
                           options.robust_sigmas});
  }
  const OptimizeResult result = optimize(graph, {});
  for (const auto& [id, node] : node_of) {
    placement[id] = result.poses[static_cast<std::size_t>(node)];
  }
  constexpr double kThrownOut = 0.05;  // of its weight left: a match elsewhere than all the others
  for (std::size_t k = 0; k < closure_of_edge.size(); ++k) {
    if (result.edges[first + k].weight < kThrownOut) {
      closures[closure_of_edge[k]].verdict = ClosureVerdict::contradicted;
    }
  }
}

}  // namespace roomatlas
