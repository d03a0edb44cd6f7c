// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/graph/room_graph.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace roomatlas {
namespace {

/// Place of an edge among `RoomGraph::edges`.
using EdgePlace = boost::property<boost::edge_index_t, std::size_t>;
/// The same vertices and edges as Boost.Graph wants them.
using BoostGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                         boost::no_property, EdgePlace>;
using Vertex = BoostGraph::vertex_descriptor;
using Edge = BoostGraph::edge_descriptor;

/// The vertex of an ASR. Throws std::out_of_range when there is none.
Vertex vertex_of(const RoomGraph& graph, AsrId id) {
  const auto at =
      std::lower_bound(graph.vertices.begin(), graph.vertices.end(), id,
                       [](const AsrVertex& vertex, AsrId wanted) { return vertex.asr < wanted; });
  if (at == graph.vertices.end() || at->asr != id) {
    throw std::out_of_range("no ASR " + std::to_string(id) + " in the graph");
  }
  return static_cast<Vertex>(at - graph.vertices.begin());
}

BoostGraph as_boost(const RoomGraph& graph) {
  BoostGraph result(graph.vertices.size());
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const PassageEdge& edge = graph.edges[i];
    boost::add_edge(vertex_of(graph, edge.from), vertex_of(graph, edge.to), EdgePlace(i), result);
  }
  return result;
}

/// The ASRs from one vertex up to the root of its tree.
std::vector<AsrId> path_to_root(const RoomGraph& graph, const std::vector<Vertex>& parent,
                                Vertex from) {
  std::vector<AsrId> path{graph.vertices[from].asr};
  while (parent[from] != from) {
    from = parent[from];
    path.push_back(graph.vertices[from].asr);
  }
  return path;
}

}  // namespace

RoomGraph build_graph(const std::vector<Asr>& asrs) {
  RoomGraph graph;
  std::set<AsrId> known;
  for (const Asr& asr : asrs) {
    graph.vertices.push_back({asr.id, asr.room});
    known.insert(asr.id);
  }
  for (const Asr& asr : asrs) {
    for (const Exit& exit : asr.exits) {
      if (exit.is_entry || !exit.neighbor || !known.contains(*exit.neighbor)) continue;
      graph.edges.push_back({asr.id, *exit.neighbor, exit.frame_from_pivot, exit.kind,
                             EdgeSource::driven, path_length_m(asr), turning(asr),
                             Eigen::Matrix3d::Zero(), asr.is_localized});
    }
  }
  return graph;
}

void add_edge(RoomGraph& graph, const PassageEdge& edge) {
  (void)vertex_of(graph, edge.from);
  (void)vertex_of(graph, edge.to);
  graph.edges.push_back(edge);
}

void doubt_passages_into(RoomGraph& graph, const std::set<AsrId>& asrs) {
  for (PassageEdge& edge : graph.edges) {
    if (edge.source == EdgeSource::driven && asrs.contains(edge.to)) edge.is_doubtful = true;
  }
}

void set_rooms(RoomGraph& graph, const std::map<AsrId, RoomId>& room_of_asr) {
  for (AsrVertex& vertex : graph.vertices) vertex.room = room_of_asr.at(vertex.asr);
}

std::vector<int> components_of(const RoomGraph& graph) {
  std::vector<int> component(graph.vertices.size());
  if (!component.empty()) boost::connected_components(as_boost(graph), component.data());
  return component;
}

std::vector<std::vector<AsrId>> cycle_basis(const RoomGraph& graph) {
  const BoostGraph whole = as_boost(graph);
  const auto place = boost::get(boost::edge_index, whole);
  const std::vector<double> weight(graph.edges.size(), 1.0);
  std::vector<Edge> tree_edges;
  boost::kruskal_minimum_spanning_tree(
      whole, std::back_inserter(tree_edges),
      boost::weight_map(boost::make_iterator_property_map(weight.begin(), place)));
  BoostGraph tree(graph.vertices.size());
  std::vector<bool> is_in_tree(graph.edges.size(), false);
  for (const Edge& edge : tree_edges) {
    is_in_tree[place[edge]] = true;
    boost::add_edge(boost::source(edge, whole), boost::target(edge, whole), tree);
  }

  std::vector<std::vector<AsrId>> cycles;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    if (is_in_tree[i]) continue;
    std::vector<Vertex> parent(graph.vertices.size());
    for (Vertex v = 0; v < parent.size(); ++v) parent[v] = v;
    boost::breadth_first_search(tree, vertex_of(graph, graph.edges[i].from),
                                boost::visitor(boost::make_bfs_visitor(boost::record_predecessors(
                                    parent.data(), boost::on_tree_edge()))));
    cycles.push_back(path_to_root(graph, parent, vertex_of(graph, graph.edges[i].to)));
  }
  return cycles;
}

std::string to_dot(const RoomGraph& graph) {
  std::ostringstream dot;
  dot << "graph rooms {\n  graph [layout=neato, overlap=scale];\n";  // `dot` itself hangs on 1000
                                                                     // edges
  for (const AsrVertex& vertex : graph.vertices) {
    dot << "  " << vertex.asr << " [label=\"ASR " << vertex.asr;
    if (vertex.room != 0) dot << "\\nroom " << vertex.room;
    dot << "\"];\n";
  }
  for (const PassageEdge& edge : graph.edges) {
    const char* style = edge.source == EdgeSource::recognised    ? "bold"
                        : edge.kind == PassageKind::open_passage ? "dashed"
                                                                 : "solid";
    dot << "  " << edge.from << " -- " << edge.to << " [style=" << style << "];\n";
  }
  dot << "}\n";
  return dot.str();
}

}  // namespace roomatlas
