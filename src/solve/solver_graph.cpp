// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "index.hpp"

namespace roomatlas {
namespace {

using Indices = std::vector<std::int32_t>;

std::int32_t root_of(Indices& parent, std::int32_t node) {
  while (parent[at(node)] != node) {
    parent[at(node)] = parent[at(parent[at(node)])];
    node = parent[at(node)];
  }
  return node;
}

SolverEdge solver_edge(const PoseEdge& edge, const Indices& slot) {
  SolverEdge result{slot[at(edge.from)],   slot[at(edge.to)],           edge.from_from_to.x_m,
                    edge.from_from_to.y_m, edge.from_from_to.theta_rad, {},
                    edge.cauchy_sigmas};
  const double c = std::cos(result.theta_rad);
  const double s = std::sin(result.theta_rad);
  const auto& o = edge.information;
  const double xx = o(0, 0);
  const double xy = o(0, 1);
  const double yy = o(1, 1);
  result.information[0] = c * c * xx - 2.0 * c * s * xy + s * s * yy;
  result.information[1] = c * s * (xx - yy) + (c * c - s * s) * xy;
  result.information[2] = s * s * xx + 2.0 * c * s * xy + c * c * yy;
  result.information[3] = c * o(0, 2) - s * o(1, 2);
  result.information[4] = s * o(0, 2) + c * o(1, 2);
  result.information[5] = o(2, 2);
  return result;
}

std::vector<bool> components_that_turn(const PoseGraph& graph, const Components& components) {
  std::vector<bool> turns(components.fixed.size(), false);
  for (const HeadingPrior& prior : graph.headings) {
    turns[at(components.component[at(prior.node)])] = true;
  }
  return turns;
}

/// Fixed nodes that turn are variables, the others stand at the end.
void number_roots(const std::vector<bool>& turns, SolverGraph& result) {
  std::int32_t end = result.variable_count;
  for (std::size_t c = 0; c < turns.size(); ++c) {
    std::int32_t& slot = result.slot[at(result.components.fixed[c])];
    if (slot == -1) slot = end++;
    result.roots.push_back(slot);
  }
}

void add_headings(const PoseGraph& graph, const std::vector<bool>& turns, SolverGraph& result) {
  constexpr double kStiffness = 1e6;  // over the stiffest edge: hardly moves, still factors
  for (const HeadingPrior& prior : graph.headings) {
    result.headings.push_back({result.slot[at(prior.node)], prior.theta_rad,
                               1.0 / (prior.sigma_rad * prior.sigma_rad), prior.cauchy_sigmas});
  }
  double stiffest = 1.0;
  if (!graph.headings.empty()) {
    for (const SolverEdge& edge : result.edges) {
      stiffest = std::max({stiffest, edge.information[0], edge.information[2]});
    }
  }
  for (std::size_t c = 0; c < turns.size(); ++c) {
    if (turns[c]) result.anchors.push_back({result.roots[c], kStiffness * stiffest});
  }
}

/// Edges by the first slot that they touch, so that neighbours in memory act on the same panels.
Indices sorted_edges(const PoseGraph& graph, const Indices& slot) {
  const auto key = [&](const PoseEdge& edge) {
    return at(std::min(slot[at(edge.from)], slot[at(edge.to)]));
  };
  Indices begin(graph.ids.size() + 1, 0);
  for (const PoseEdge& edge : graph.edges) ++begin[key(edge) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  Indices order(graph.edges.size());
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    order[at(begin[key(graph.edges[e])]++)] = static_cast<std::int32_t>(e);
  }
  return order;
}

}  // namespace

Components components_of(const PoseGraph& graph) {
  Indices parent(graph.ids.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto lower_id = [&](std::int32_t a, std::int32_t b) {
    return graph.ids[at(a)] < graph.ids[at(b)];
  };
  for (const PoseEdge& edge : graph.edges) {
    const std::int32_t a = root_of(parent, edge.from);
    const std::int32_t b = root_of(parent, edge.to);
    parent[at(lower_id(a, b) ? b : a)] = lower_id(a, b) ? a : b;  // the root has the lowest id
  }
  Components result;
  for (std::size_t i = 0; i < parent.size(); ++i) {
    if (parent[i] == static_cast<std::int32_t>(i)) {
      result.fixed.push_back(static_cast<std::int32_t>(i));
    }
  }
  std::ranges::sort(result.fixed, lower_id);
  result.component.resize(parent.size());
  for (std::size_t c = 0; c < result.fixed.size(); ++c) {
    result.component[at(result.fixed[c])] = static_cast<std::int32_t>(c);
  }
  for (std::size_t i = 0; i < parent.size(); ++i) {
    result.component[i] = result.component[at(root_of(parent, static_cast<std::int32_t>(i)))];
  }
  return result;
}

SolverGraph solver_graph_of(const PoseGraph& graph) {
  SolverGraph result;
  result.components = components_of(graph);
  Indices& slot = result.slot;
  slot.assign(graph.ids.size(), 0);
  const std::vector<bool> turns = components_that_turn(graph, result.components);
  for (std::size_t c = 0; c < turns.size(); ++c) {
    if (!turns[c]) slot[at(result.components.fixed[c])] = -1;
  }
  for (std::int32_t& number : slot) {
    if (number == 0) number = result.variable_count++;
  }
  std::vector<NodePair> pairs;
  pairs.reserve(graph.edges.size());
  for (const PoseEdge& edge : graph.edges) {
    const std::int32_t a = slot[at(edge.from)];
    const std::int32_t b = slot[at(edge.to)];
    if (a != -1 && b != -1) pairs.emplace_back(a, b);
  }
  result.supernodes = find_supernodes(at(result.variable_count), pairs);
  std::vector<NodePair>().swap(pairs);
  for (std::int32_t& number : slot) {
    if (number != -1) number = result.supernodes.position[at(number)];
  }
  number_roots(turns, result);
  result.edge_index = sorted_edges(graph, slot);
  result.edges.reserve(graph.edges.size());
  for (const std::int32_t e : result.edge_index) {
    result.edges.push_back(solver_edge(graph.edges[at(e)], slot));
  }
  add_headings(graph, turns, result);
  return result;
}

}  // namespace roomatlas
