// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/graph/bridges.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/biconnected_components.hpp>
#include <map>
#include <utility>

namespace roomatlas {
namespace {

using Numbered = boost::property<boost::edge_index_t, std::size_t>;
using BoostGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                         boost::no_property, Numbered>;
using Ends = std::pair<std::size_t, std::size_t>;

std::map<AsrId, std::size_t> places_of(const RoomGraph& graph) {
  std::map<AsrId, std::size_t> place_of;
  for (std::size_t i = 0; i < graph.vertices.size(); ++i) place_of[graph.vertices[i].asr] = i;
  return place_of;
}

/// The edges between each two visits, by their places; those from a visit to itself left out.
std::map<Ends, std::vector<std::size_t>> edges_by_ends(const RoomGraph& graph) {
  const std::map<AsrId, std::size_t> place_of = places_of(graph);
  std::map<Ends, std::vector<std::size_t>> edges;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const std::size_t a = place_of.at(graph.edges[i].from);
    const std::size_t b = place_of.at(graph.edges[i].to);
    if (a != b) edges[std::minmax(a, b)].push_back(i);
  }
  return edges;
}

/// The visits that are reached from one end without passing the bridge.
std::set<AsrId> side_of(const RoomGraph& graph, std::size_t bridge, AsrId from) {
  std::map<AsrId, std::vector<AsrId>> next;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    if (i == bridge) continue;
    next[graph.edges[i].from].push_back(graph.edges[i].to);
    next[graph.edges[i].to].push_back(graph.edges[i].from);
  }
  std::set<AsrId> side{from};
  std::vector<AsrId> open{from};
  while (!open.empty()) {
    const AsrId at = open.back();
    open.pop_back();
    for (const AsrId other : next[at]) {
      if (side.insert(other).second) open.push_back(other);
    }
  }
  return side;
}

/// Of each edge of the graph without doubled ones, how many visits lie behind it in the tree that
/// a depth-first search makes, and how many its component has.
class Tree {
 public:
  explicit Tree(std::size_t vertices) : next_(vertices), size_(vertices, 0), root_(vertices, 0) {}
  void add(const Ends& ends) {
    next_[ends.first].push_back(ends.second);
    next_[ends.second].push_back(ends.first);
  }
  void grow() {
    std::vector<bool> is_seen(next_.size(), false);
    for (std::size_t root = 0; root < next_.size(); ++root) {
      if (!is_seen[root]) grow(root, is_seen);
    }
  }
  /// Of an edge that is a bridge: every search tree has it.
  [[nodiscard]] std::size_t smaller_side(const Ends& bridge) const {
    const std::size_t below = std::min(size_[bridge.first], size_[bridge.second]);
    return std::min(below, size_[root_[bridge.first]] - below);
  }

 private:
  void grow(std::size_t root, std::vector<bool>& is_seen) {
    std::vector<std::pair<std::size_t, std::size_t>> order{{root, root}};  // vertex, parent
    is_seen[root] = true;
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (const std::size_t other : next_[order[i].first]) {
        if (is_seen[other]) continue;
        is_seen[other] = true;
        order.emplace_back(other, order[i].first);
      }
    }
    std::reverse(order.begin(), order.end());
    for (const auto& [vertex, parent] : order) {
      root_[vertex] = root;
      ++size_[vertex];
      if (vertex != root) size_[parent] += size_[vertex];
    }
  }

  std::vector<std::vector<std::size_t>> next_;
  std::vector<std::size_t> size_;  ///< of what hangs on a vertex, itself included
  std::vector<std::size_t> root_;
};

}  // namespace

std::vector<Bridge> bridges_of(const RoomGraph& graph) {
  const auto edges = edges_by_ends(graph);
  BoostGraph simple(graph.vertices.size());
  Tree tree(graph.vertices.size());
  std::vector<Ends> ends;
  for (const auto& [between, places] : edges) {
    boost::add_edge(between.first, between.second, Numbered(ends.size()), simple);
    tree.add(between);
    ends.push_back(between);
  }
  tree.grow();
  std::vector<std::size_t> component(ends.size(), 0);
  const std::size_t components = boost::biconnected_components(
      simple,
      boost::make_iterator_property_map(component.begin(), boost::get(boost::edge_index, simple)));
  std::vector<int> members(components + 1, 0);
  for (const std::size_t of : component) ++members.at(of);
  std::vector<Bridge> bridges;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::vector<std::size_t>& places = edges.at(ends[i]);
    if (members.at(component[i]) > 1 || places.size() > 1) continue;
    bridges.push_back({places.front(), tree.smaller_side(ends[i])});
  }
  std::sort(bridges.begin(), bridges.end(),
            [](const Bridge& a, const Bridge& b) { return a.edge < b.edge; });
  return bridges;
}

std::set<AsrId> visits_behind(const RoomGraph& graph, const Bridge& bridge) {
  const PassageEdge& edge = graph.edges.at(bridge.edge);
  const AsrId earlier = std::min(edge.from, edge.to);
  const AsrId later = std::max(edge.from, edge.to);
  std::set<AsrId> behind_later = side_of(graph, bridge.edge, later);
  if (behind_later.size() == bridge.behind) return behind_later;
  return side_of(graph, bridge.edge, earlier);
}

}  // namespace roomatlas
