// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/graph/bridges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace roomatlas {
namespace {

RoomGraph graph_of(AsrId visits, const std::vector<std::pair<AsrId, AsrId>>& edges) {
  RoomGraph graph;
  for (AsrId id = 1; id <= visits; ++id) graph.vertices.push_back({id, 0});
  for (const auto& [from, to] : edges) {
    PassageEdge edge;
    edge.from = from;
    edge.to = to;
    graph.edges.push_back(edge);
  }
  return graph;
}

int count_components(const RoomGraph& graph) {
  const std::vector<int> component = components_of(graph);
  return 1 + *std::max_element(component.begin(), component.end());
}

RoomGraph without(const RoomGraph& graph, std::size_t edge) {
  RoomGraph rest = graph;
  rest.edges.erase(rest.edges.begin() + static_cast<std::ptrdiff_t>(edge));
  return rest;
}

TEST(Bridges, AreTheEdgesWithoutWhichThereIsOneComponentMore) {
  std::mt19937 random(4);
  int found = 0;
  for (int round = 0; round < 200; ++round) {
    std::uniform_int_distribution<AsrId> visit(1, 9);
    std::vector<std::pair<AsrId, AsrId>> edges;
    for (int i = 0; i < 10; ++i) edges.emplace_back(visit(random), visit(random));
    const RoomGraph graph = graph_of(9, edges);
    const std::vector<Bridge> bridges = bridges_of(graph);
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
      const RoomGraph rest = without(graph, i);
      const auto bridge = std::find_if(bridges.begin(), bridges.end(),
                                       [&](const Bridge& one) { return one.edge == i; });
      ASSERT_EQ(bridge != bridges.end(), count_components(rest) > count_components(graph));
      if (bridge == bridges.end()) continue;
      ++found;
      const std::vector<int> component = components_of(rest);
      const auto size_of = [&](AsrId id) {
        return static_cast<std::size_t>(
            std::count(component.begin(), component.end(), component[std::size_t(id) - 1]));
      };
      const std::size_t smaller =
          std::min(size_of(graph.edges[i].from), size_of(graph.edges[i].to));
      ASSERT_EQ(bridge->behind, smaller);
      ASSERT_EQ(visits_behind(graph, *bridge).size(), smaller);
    }
  }
  EXPECT_GT(found, 100);
}

TEST(Bridges, TwoEdgesBetweenTheSameVisitsAreNone) {
  EXPECT_TRUE(bridges_of(graph_of(2, {{1, 2}, {2, 1}})).empty());
  EXPECT_EQ(bridges_of(graph_of(3, {{1, 2}, {2, 1}, {2, 3}})).size(), 1U);
}

TEST(Bridges, OfALoopWithATailTheTailHangsOnOne) {
  const RoomGraph graph =
      graph_of(7, {{1, 2}, {2, 3}, {3, 4}, {4, 1}, {4, 5}, {5, 6}, {6, 7}, {7, 5}});
  const std::vector<Bridge> bridges = bridges_of(graph);
  ASSERT_EQ(bridges.size(), 1U);
  EXPECT_EQ(visits_behind(graph, bridges[0]), (std::set<AsrId>{5, 6, 7}));
}

}  // namespace
}  // namespace roomatlas
