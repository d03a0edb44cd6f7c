// SPDX-License-Identifier: GPL-3.0-or-later
#include "spanning_tree.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "index.hpp"

namespace roomatlas {
namespace {

using Indices = std::vector<std::int32_t>;

bool is_used(std::span<const double> weights, std::size_t e) {
  return weights.empty() || weights[e] > 0.0;
}

/// Headings along the tree, not wrapped, so that what they differ by over an edge counts turns.
std::vector<double> unwrapped_headings(const SolverGraph& graph, const SpanningTree& tree) {
  std::vector<double> headings(graph.slot.size(), 0.0);
  for (const std::int32_t slot : tree.order) {
    const std::int32_t e = tree.via[at(slot)];
    if (e == -1) continue;
    const SolverEdge& edge = graph.edges[at(e)];
    headings[at(slot)] = edge.to == slot ? headings[at(edge.from)] + edge.theta_rad
                                         : headings[at(edge.to)] - edge.theta_rad;
  }
  return headings;
}

}  // namespace

Incidence incidence_of(const SolverGraph& graph) {
  Indices end(graph.slot.size() + 1, 0);
  for (const SolverEdge& edge : graph.edges) {
    ++end[at(edge.from) + 1];
    ++end[at(edge.to) + 1];
  }
  for (std::size_t k = 1; k < end.size(); ++k) end[k] += end[k - 1];
  Incidence incidence{end, Indices(graph.edges.size() * 2)};
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    incidence.edges[at(end[at(graph.edges[e].from)]++)] = static_cast<std::int32_t>(e);
    incidence.edges[at(end[at(graph.edges[e].to)]++)] = static_cast<std::int32_t>(e);
  }
  return incidence;
}

SpanningTree spanning_tree(const SolverGraph& graph, const Incidence& incidence,
                           std::span<const std::uint8_t> costly, std::span<const double> weights) {
  SpanningTree tree{{}, Indices(graph.slot.size(), -1)};
  std::vector<std::uint8_t> reached(graph.slot.size(), 0);
  struct Step {
    std::int32_t slot;
    std::int32_t via;
  };
  std::deque<Step> waiting;
  for (const std::int32_t root : graph.roots) waiting.push_back({root, -1});
  std::deque<Step> later;  // steps over costly edges
  while (!waiting.empty() || !later.empty()) {
    std::deque<Step>& queue = waiting.empty() ? later : waiting;
    const Step step = queue.front();
    queue.pop_front();
    if (reached[at(step.slot)] != 0) continue;
    reached[at(step.slot)] = 1;
    tree.via[at(step.slot)] = step.via;
    tree.order.push_back(step.slot);
    for (auto k = incidence.begin[at(step.slot)]; k < incidence.begin[at(step.slot) + 1]; ++k) {
      const std::int32_t e = incidence.edges[at(k)];
      const SolverEdge& edge = graph.edges[at(e)];
      const std::int32_t other = edge.from + edge.to - step.slot;
      if (reached[at(other)] != 0 || !is_used(weights, at(e))) continue;
      (!costly.empty() && costly[at(e)] != 0 ? later : waiting).push_back({other, e});
    }
  }
  return tree;
}

SlotPoses poses_along(const SolverGraph& graph, const SpanningTree& tree) {
  SlotPoses state(graph.slot.size() * 3, 0.0);
  const auto pose = [&](std::int32_t slot) {
    const double* const p = state.data() + std::ptrdiff_t{slot} * 3;
    return Pose2{p[0], p[1], p[2]};
  };
  for (const std::int32_t slot : tree.order) {
    const std::int32_t e = tree.via[at(slot)];
    if (e == -1) continue;
    const SolverEdge& edge = graph.edges[at(e)];
    const Pose2 from_from_to{edge.x_m, edge.y_m, edge.theta_rad};
    const Pose2 reached =
        edge.to == slot ? pose(edge.from) * from_from_to : pose(edge.to) * inverse(from_from_to);
    double* const p = state.data() + std::ptrdiff_t{slot} * 3;
    p[0] = reached.x_m;
    p[1] = reached.y_m;
    p[2] = reached.theta_rad;
  }
  return state;
}

bool winds_right(const SolverGraph& graph, const SpanningTree& tree, const SlotPoses& state,
                 std::span<const double> weights) {
  const auto error = [&](const SolverEdge& edge) {
    return wrap_angle(state[at(edge.to) * 3 + 2] - state[at(edge.from) * 3 + 2] - edge.theta_rad);
  };
  std::vector<double> sum(graph.slot.size(), 0.0);  // of errors from the fixed node on
  for (const std::int32_t slot : tree.order) {
    const std::int32_t e = tree.via[at(slot)];
    if (e == -1) continue;
    const SolverEdge& edge = graph.edges[at(e)];
    sum[at(slot)] =
        edge.to == slot ? sum[at(edge.from)] + error(edge) : sum[at(edge.to)] - error(edge);
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (!is_used(weights, e)) continue;
    const SolverEdge& edge = graph.edges[e];
    if (std::abs(sum[at(edge.to)] - sum[at(edge.from)] - error(edge)) > kPi) return false;
  }
  return true;
}

SlotPoses headings_by_winding(const SolverGraph& graph, const SpanningTree& tree,
                              std::span<const double> weights) {
  const std::vector<double> along = unwrapped_headings(graph, tree);
  BlockCholesky<1> matrix(graph.supernodes);
  matrix.clear();
  std::vector<double> headings(at(graph.variable_count), 0.0);
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (!is_used(weights, e)) continue;
    const SolverEdge& edge = graph.edges[e];
    const double weight = (weights.empty() ? 1.0 : weights[e]) * edge.information[5];
    const double turned = along[at(edge.to)] - along[at(edge.from)];
    const double measured = turned - wrap_angle(turned - edge.theta_rad);
    const bool from_moves = edge.from < graph.variable_count;
    const bool to_moves = edge.to < graph.variable_count;
    if (from_moves) {
      matrix.values()[matrix.place(edge.from, edge.from).offset] += weight;
      headings[at(edge.from)] -= weight * measured;
    }
    if (to_moves) {
      matrix.values()[matrix.place(edge.to, edge.to).offset] += weight;
      headings[at(edge.to)] += weight * measured;
    }
    if (from_moves && to_moves) {
      const std::int32_t row = std::max(edge.from, edge.to);
      matrix.values()[matrix.place(row, edge.from + edge.to - row).offset] -= weight;
    }
  }
  for (const Anchor& anchor : graph.anchors) {
    matrix.values()[matrix.place(anchor.slot, anchor.slot).offset] += 1.0;
  }
  if (matrix.factorize() != -1) return {};
  matrix.solve(headings.data());
  SlotPoses state(graph.slot.size() * 3, 0.0);
  for (std::size_t k = 0; k < headings.size(); ++k) state[k * 3 + 2] = wrap_angle(headings[k]);
  return state;
}

}  // namespace roomatlas
