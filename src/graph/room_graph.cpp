// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/graph/room_graph.hpp"

#include <algorithm>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace roomatlas {
namespace {

using Vertex = RoomGraph::vertex_descriptor;
using Edge = RoomGraph::edge_descriptor;

std::vector<AsrId> path_to_root(const RoomGraph& tree, const std::vector<Vertex>& parent,
                                Vertex from) {
  std::vector<AsrId> path{tree[from].asr};
  while (parent[from] != from) {
    from = parent[from];
    path.push_back(tree[from].asr);
  }
  return path;
}

}  // namespace

RoomGraph build_graph(const std::vector<Asr>& asrs) {
  RoomGraph graph;
  std::map<AsrId, Vertex> vertex_of;
  for (const Asr& asr : asrs) vertex_of[asr.id] = boost::add_vertex({asr.id, asr.room}, graph);
  for (const Asr& asr : asrs) {
    for (const Exit& exit : asr.exits) {
      if (exit.is_entry || !exit.neighbor || !vertex_of.contains(*exit.neighbor)) continue;
      boost::add_edge(vertex_of[asr.id], vertex_of[*exit.neighbor],
                      {asr.id, *exit.neighbor, exit.asr_from_pivot, exit.kind, EdgeSource::driven,
                       path_length_m(asr), turning(asr), Eigen::Matrix3d::Zero(), asr.is_localized},
                      graph);
    }
  }
  return graph;
}

void add_edge(RoomGraph& graph, const PassageEdge& edge) {
  const auto vertex_of = [&](AsrId id) {
    const auto [begin, end] = boost::vertices(graph);
    const auto at = std::lower_bound(begin, end, id,
                                     [&](Vertex v, AsrId wanted) { return graph[v].asr < wanted; });
    if (at == end || graph[*at].asr != id)
      throw std::out_of_range("no ASR " + std::to_string(id) + " in the graph");
    return *at;
  };
  boost::add_edge(vertex_of(edge.from), vertex_of(edge.to), edge, graph);
}

void doubt_passages_into(RoomGraph& graph, const std::set<AsrId>& asrs) {
  for (const auto& edge : boost::make_iterator_range(boost::edges(graph))) {
    PassageEdge& passage = graph[edge];
    if (passage.source == EdgeSource::driven && asrs.count(passage.to) > 0) {
      passage.is_doubtful = true;
    }
  }
}

void set_rooms(RoomGraph& graph, const std::map<AsrId, RoomId>& room_of_asr) {
  for (const Vertex v : boost::make_iterator_range(boost::vertices(graph))) {
    graph[v].room = room_of_asr.at(graph[v].asr);
  }
}

std::vector<PassageEdge> edges_of(const RoomGraph& graph) {
  std::vector<PassageEdge> edges;
  for (const Edge& edge : boost::make_iterator_range(boost::edges(graph))) {
    edges.push_back(graph[edge]);
  }
  return edges;
}

std::vector<int> components_of(const RoomGraph& graph) {
  std::vector<int> component(boost::num_vertices(graph));
  if (!component.empty()) boost::connected_components(graph, component.data());
  return component;
}

std::vector<std::vector<AsrId>> cycle_basis(const RoomGraph& graph) {
  std::map<Edge, double> weight;
  for (const Edge& edge : boost::make_iterator_range(boost::edges(graph))) weight[edge] = 1.0;
  std::vector<Edge> tree_edges;
  boost::kruskal_minimum_spanning_tree(
      graph, std::back_inserter(tree_edges),
      boost::weight_map(boost::associative_property_map<std::map<Edge, double>>(weight)));

  const auto is_in_tree = [&](const Edge& edge) {
    return std::find(tree_edges.begin(), tree_edges.end(), edge) != tree_edges.end();
  };
  RoomGraph tree;
  for (const Vertex v : boost::make_iterator_range(boost::vertices(graph))) {
    boost::add_vertex(graph[v], tree);
  }
  for (const Edge& edge : tree_edges) {
    boost::add_edge(boost::source(edge, graph), boost::target(edge, graph), graph[edge], tree);
  }

  std::vector<std::vector<AsrId>> cycles;
  for (const Edge& edge : boost::make_iterator_range(boost::edges(graph))) {
    if (is_in_tree(edge)) continue;
    const Vertex root = boost::source(edge, graph);
    std::vector<Vertex> parent(boost::num_vertices(tree));
    for (Vertex v = 0; v < parent.size(); ++v) parent[v] = v;
    boost::breadth_first_search(tree, root,
                                boost::visitor(boost::make_bfs_visitor(boost::record_predecessors(
                                    parent.data(), boost::on_tree_edge()))));
    cycles.push_back(path_to_root(tree, parent, boost::target(edge, graph)));
  }
  return cycles;
}

std::string to_dot(const RoomGraph& graph) {
  std::ostringstream dot;
  dot << "graph rooms {\n  graph [layout=neato, overlap=scale];\n";  // `dot` itself hangs on 1000
                                                                     // edges
  for (const Vertex v : boost::make_iterator_range(boost::vertices(graph))) {
    dot << "  " << graph[v].asr << " [label=\"ASR " << graph[v].asr;
    if (graph[v].room != 0) dot << "\\nroom " << graph[v].room;
    dot << "\"];\n";
  }
  for (const PassageEdge& edge : edges_of(graph)) {
    const char* style = edge.source == EdgeSource::recognised    ? "bold"
                        : edge.kind == PassageKind::open_passage ? "dashed"
                                                                 : "solid";
    dot << "  " << edge.from << " -- " << edge.to << " [style=" << style << "];\n";
  }
  dot << "}\n";
  return dot.str();
}

}  // namespace roomatlas
