// SPDX-License-Identifier: GPL-3.0-or-later
#include "placed_graph.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/solve/optimize.hpp"

namespace roomatlas {
namespace {

Uncertainty uncertainty_of(const Eigen::Matrix3d& covariance) {
  return {std::sqrt(std::max({0.0, covariance(0, 0), covariance(1, 1)})),
          std::sqrt(std::max(0.0, covariance(2, 2)))};
}

PoseEdge edge_between(std::size_t from, std::size_t to, EdgeKind kind, const Pose2& from_from_to,
                      const Eigen::Matrix3d& information, double robust_sigmas) {
  return {static_cast<std::int32_t>(from),
          static_cast<std::int32_t>(to),
          kind,
          from_from_to,
          information,
          robust_sigmas};
}

}  // namespace

void PlacedGraph::add_node(AsrId id, const Pose2& pose) {
  graph_.ids.push_back(id);
  graph_.guess.push_back(pose);
}

void PlacedGraph::add_driven(std::size_t from, std::size_t to, const Pose2& from_from_to,
                             const Eigen::Matrix3d& information) {
  graph_.edges.push_back(
      edge_between(from, to, EdgeKind::odometry, from_from_to, information, 0.0));
}

void PlacedGraph::add(const Pair& pair, const MapMatch& match, double robust_sigmas) {
  graph_.edges.push_back(edge_between(pair.first, pair.second, EdgeKind::loop,
                                      match.first_from_second, match.information, robust_sigmas));
}

void PlacedGraph::remove_closures() {
  std::erase_if(graph_.edges, [](const PoseEdge& e) { return e.kind == EdgeKind::loop; });
}

void PlacedGraph::doubt_passages(double robust_sigmas) {
  for (PoseEdge& edge : graph_.edges) {
    if (edge.kind == EdgeKind::odometry) edge.cauchy_sigmas = robust_sigmas;
  }
}

std::set<AsrId> PlacedGraph::keep_doubts() {
  std::set<AsrId> into;
  for (PoseEdge& edge : graph_.edges) {
    if (edge.kind != EdgeKind::odometry || edge.cauchy_sigmas == 0.0) continue;
    const auto from = static_cast<std::size_t>(edge.from);
    const auto to = static_cast<std::size_t>(edge.to);
    const double chi = chi_square(edge, graph_.guess[from], graph_.guess[to]);
    if (chi > edge.cauchy_sigmas * edge.cauchy_sigmas) {
      into.insert(graph_.ids[to]);
    } else {
      edge.cauchy_sigmas = 0.0;
    }
  }
  return into;
}

void PlacedGraph::solve() {
  if (!graph_.edges.empty()) graph_.guess = optimize(graph_, {}).poses;
}

std::vector<Uncertainty> PlacedGraph::uncertainties(const std::vector<Pair>& pairs) {
  if (pairs.empty()) return {};
  PoseGraph asked = graph_;
  for (const Pair& pair : pairs) {  // edges that say nothing, to be asked about
    asked.edges.push_back(edge_between(pair.first, pair.second, EdgeKind::loop,
                                       first_from_second(pair), Eigen::Matrix3d::Zero(), 0.0));
  }
  OptimizeOptions options;
  options.covariance = true;
  const OptimizeResult result = optimize(asked, options);
  graph_.guess = result.poses;
  std::vector<Uncertainty> found;
  for (std::size_t i = graph_.edges.size(); i < asked.edges.size(); ++i) {
    found.push_back(uncertainty_of(result.covariance.of_edge[i]));
  }
  return found;
}

Pose2 PlacedGraph::first_from_second(const Pair& pair) const {
  return inverse(graph_.guess[pair.first]) * graph_.guess[pair.second];
}

}  // namespace roomatlas
