// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_graph.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "roomatlas/grid/cells.hpp"
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

/// Places of visits in squares, for the nearest ones: a store of many missions is one mission here,
/// and may have thousands.
class EarlierVisits {
 public:
  void add(const Point2& at) {
    const Cell cell = frame_.cell_of(at);
    squares_[{cell.y, cell.x}].push_back(places_.size());
    places_.push_back(at);
  }

  /// By distance, then by number; fewer than `count` only where there are no more.
  [[nodiscard]] std::vector<std::size_t> nearest(const Point2& at, std::size_t count) const {
    std::vector<std::pair<double, std::size_t>> found;
    const std::size_t wanted = std::min(count, places_.size());
    const Cell middle = frame_.cell_of(at);
    // Whatever lies outside of `ring` squares is at least so many sides away.
    for (int ring = 0; wanted > 0; ++ring) {
      for_each_cell(
          {{middle.x - ring, middle.y - ring}, {middle.x + ring + 1, middle.y + ring + 1}},
          [&](const Cell& cell) {
            const bool is_on_ring =
                std::abs(cell.x - middle.x) == ring || std::abs(cell.y - middle.y) == ring;
            if (!is_on_ring) return;
            const auto there = squares_.find({cell.y, cell.x});
            if (there == squares_.end()) return;
            for (const std::size_t i : there->second) {
              found.emplace_back((places_[i] - at).norm(), i);
            }
          });
      if (found.size() < wanted) continue;
      std::sort(found.begin(), found.end());
      if (found[wanted - 1].first <= ring * frame_.cell_m) break;
    }
    std::vector<std::size_t> nearest;
    for (std::size_t k = 0; k < wanted; ++k) nearest.push_back(found[k].second);
    return nearest;
  }

 private:
  static constexpr double kSquareM = 4.0;  ///< a room or so
  CellFrame frame_{kSquareM};
  std::map<std::pair<int, int>, std::vector<std::size_t>> squares_;
  std::vector<Point2> places_;
};

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
    EarlierVisits visits;
    for (std::size_t i = 1; i < mission_.shapes.size(); ++i) {
      if (i > 1) visits.add(pose(i - 2).position());
      std::vector<std::size_t> held_to = visits.nearest(pose(i).position(), neighbours_);
      held_to.push_back(i - 1);
      for (const std::size_t earlier : held_to) {
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

  const MissionMap& mission_;
  const OwnSigmas& sigmas_;
  double robust_sigmas_;
  double own_heading_rad_;
  std::size_t neighbours_;
};

}  // namespace

namespace {

using NodeOf = std::map<AsrId, std::int32_t>;

constexpr double kThrownOut = 0.05;  // of its weight left: a match elsewhere than all the others

void add_nodes(const MissionMap& mission, const Placement& placement, PoseGraph& graph,
               NodeOf& node_of) {
  for (const AsrShape& shape : mission.shapes) {
    node_of[shape.id] = static_cast<std::int32_t>(graph.ids.size());
    graph.ids.push_back(shape.id);
    graph.guess.push_back(placement.at(shape.id));
  }
}

/// Solves, moves the visits, and tells closures that were thrown out.
/// @param closure_of_edge of the edges from `first` on
/// @returns how many were thrown out
int solve(const PoseGraph& graph, const NodeOf& node_of,
          const std::vector<Closure*>& closure_of_edge, std::size_t first, Placement& placement) {
  const OptimizeResult result = optimize(graph, {});
  for (const auto& [id, node] : node_of) {
    placement[id] = result.poses[static_cast<std::size_t>(node)];
  }
  int thrown_out = 0;
  for (std::size_t k = 0; k < closure_of_edge.size(); ++k) {
    if (result.edges[first + k].weight >= kThrownOut) continue;
    closure_of_edge[k]->verdict = ClosureVerdict::contradicted;
    ++thrown_out;
  }
  return thrown_out;
}

}  // namespace

void solve_joint(const std::vector<const MissionMap*>& missions, const JoinOptions& options,
                 Placement& placement, std::vector<Closure>& closures, double loss_width) {
  PoseGraph graph;
  NodeOf node_of;
  for (const MissionMap* mission : missions) add_nodes(*mission, placement, graph, node_of);
  for (const MissionMap* mission : missions)
    OwnMeasurements(*mission, options).add_to(graph, node_of);
  std::vector<Closure*> closure_of_edge;
  const std::size_t first = graph.edges.size();
  for (Closure& closure : closures) {
    if (closure.verdict != ClosureVerdict::accepted || !node_of.contains(closure.from)) continue;
    closure_of_edge.push_back(&closure);
    graph.edges.push_back({node_of.at(closure.from), node_of.at(closure.to), EdgeKind::loop,
                           closure.match.first_from_second, closure.match.information,
                           loss_width * options.robust_sigmas});
  }
  (void)solve(graph, node_of, closure_of_edge, first, placement);
}

bool solve_alone(const MissionMap& mission, const JoinOptions& options, Placement& placement,
                 std::span<Closure> closures) {
  // All that stays is one node, the first, which the solver holds: what lies in it is measured
  // from its frame.
  PoseGraph graph;
  graph.ids.push_back(0);
  graph.guess.emplace_back();
  NodeOf node_of;
  add_nodes(mission, placement, graph, node_of);
  OwnMeasurements(mission, options).add_to(graph, node_of);
  std::vector<Closure*> closure_of_edge;
  const std::size_t first = graph.edges.size();
  for (Closure& closure : closures) {
    if (closure.verdict != ClosureVerdict::accepted) continue;
    closure_of_edge.push_back(&closure);
    graph.edges.push_back({0, node_of.at(closure.to), EdgeKind::loop,
                           placement.at(closure.from) * closure.match.first_from_second,
                           closure.match.information, options.robust_sigmas});
  }
  if (closure_of_edge.empty()) return true;  // nothing holds it but where it was found
  return solve(graph, node_of, closure_of_edge, first, placement) == 0;
}

}  // namespace roomatlas
