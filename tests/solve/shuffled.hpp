// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "roomatlas/correct/place.hpp"
#include "support/generated_pose_graph.hpp"

namespace roomatlas::test {

/// Nodes, edges and headings in another order.
inline PoseGraph shuffled(const PoseGraph& graph, std::uint64_t seed) {
  Dice dice(seed);
  std::vector<std::size_t> order(graph.ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto shuffle = [&](auto& items) {
    for (std::size_t k = items.size(); k-- > 1;) {
      std::swap(items[k], items[static_cast<std::size_t>(dice.below(static_cast<int>(k) + 1))]);
    }
  };
  shuffle(order);
  PoseGraph result;
  std::vector<std::int32_t> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    result.ids.push_back(graph.ids[order[k]]);
    place[order[k]] = static_cast<std::int32_t>(k);
  }
  result.edges = graph.edges;
  for (PoseEdge& edge : result.edges) {
    edge.from = place[static_cast<std::size_t>(edge.from)];
    edge.to = place[static_cast<std::size_t>(edge.to)];
  }
  if (!graph.guess.empty()) {
    for (const std::size_t old : order) result.guess.push_back(graph.guess[old]);
  }
  result.headings = graph.headings;
  for (HeadingPrior& prior : result.headings) {
    prior.node = place[static_cast<std::size_t>(prior.node)];
  }
  shuffle(result.edges);
  shuffle(result.headings);
  return result;
}

}  // namespace roomatlas::test
