// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/plan_graph.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/vf2_sub_graph_iso.hpp>
#include <utility>
#include <vector>

namespace roomatlas {
namespace {

using Vertex = std::size_t;
using Edge = std::pair<Vertex, Vertex>;      ///< the smaller first
using Edges = std::map<Edge, std::int64_t>;  ///< how many doors join the two

/// Rooms in the order of the plan.
struct DoorGraph {
  std::map<RoomId, Vertex> vertex_of;
  Edges doors;
  std::int64_t edges = 0;
};

DoorGraph graph_of(const FloorPlan& plan) {
  DoorGraph graph;
  for (const PlanRoom& room : plan.rooms) {
    graph.vertex_of.emplace(room.id, graph.vertex_of.size());
  }
  for (const PlanDoor& door : plan.doors) {
    if (!door.room_a || !door.room_b || *door.room_a == *door.room_b) continue;
    const auto a = graph.vertex_of.find(*door.room_a);
    const auto b = graph.vertex_of.find(*door.room_b);
    if (a == graph.vertex_of.end() || b == graph.vertex_of.end()) continue;
    ++graph.doors[std::minmax(a->second, b->second)];
    ++graph.edges;
  }
  return graph;
}

using Colours = std::vector<int>;

/// What a vertex looks like from its neighbours: its colour, and each neighbour's with the doors.
using Look = std::pair<int, std::vector<std::pair<int, std::int64_t>>>;

std::vector<Look> looks_of(const DoorGraph& graph, const Colours& colours) {
  std::vector<Look> looks;
  for (const int colour : colours) looks.push_back({colour, {}});
  for (const auto& [edge, count] : graph.doors) {
    looks[edge.first].second.push_back({colours[edge.second], count});
    looks[edge.second].second.push_back({colours[edge.first], count});
  }
  for (Look& look : looks) std::sort(look.second.begin(), look.second.end());
  return looks;
}

Colours sorted(Colours colours) {
  std::sort(colours.begin(), colours.end());
  return colours;
}

/// Colours both graphs' vertices until nothing more can be told apart (Weisfeiler and Leman 1968).
/// @returns false when the graphs then differ
bool refine(const DoorGraph& first, const DoorGraph& second, Colours& a, Colours& b) {
  a.assign(first.vertex_of.size(), 0);
  b.assign(second.vertex_of.size(), 0);
  for (std::size_t round = 0; round <= a.size(); ++round) {
    const std::vector<Look> looks_a = looks_of(first, a);
    const std::vector<Look> looks_b = looks_of(second, b);
    std::map<Look, int> colour_of;
    for (const auto* looks : {&looks_a, &looks_b}) {
      for (const Look& look : *looks) colour_of.emplace(look, 0);
    }
    int next = 0;
    for (auto& entry : colour_of) entry.second = next++;
    for (Vertex i = 0; i < a.size(); ++i) a[i] = colour_of.at(looks_a[i]);
    for (Vertex i = 0; i < b.size(); ++i) b[i] = colour_of.at(looks_b[i]);
    if (sorted(a) != sorted(b)) return false;
  }
  return true;
}

struct DoorCount {
  std::int64_t doors = 0;
};
using BoostGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                         boost::no_property, DoorCount>;

BoostGraph boost_graph_of(const DoorGraph& graph) {
  BoostGraph result(graph.vertex_of.size());
  for (const auto& [edge, count] : graph.doors) {
    boost::add_edge(edge.first, edge.second, DoorCount{count}, result);
  }
  return result;
}

bool isomorphic(const DoorGraph& plan, const DoorGraph& truth) {
  if (plan.vertex_of.size() != truth.vertex_of.size()) return false;
  if (plan.doors.size() != truth.doors.size() || plan.edges != truth.edges) return false;
  Colours colours;
  Colours true_colours;
  if (!refine(plan, truth, colours, true_colours)) return false;
  if (plan.doors.empty()) return true;
  const BoostGraph a = boost_graph_of(plan);
  const BoostGraph b = boost_graph_of(truth);
  const auto stop_at_the_first = [](const auto&, const auto&) { return false; };
  const auto same_doors = [&](const auto& x, const auto& y) { return a[x].doors == b[y].doors; };
  const auto same_colour = [&](Vertex x, Vertex y) { return colours[x] == true_colours[y]; };
  return boost::vf2_graph_iso(a, b, stop_at_the_first, get(boost::vertex_index, a),
                              get(boost::vertex_index, b), boost::vertex_order_by_mult(a),
                              same_doors, same_colour);
}

/// Counts the edits that lead from the plan's edges to the true ones.
void count_edits(const DoorGraph& plan, const DoorGraph& truth,
                 const std::map<Vertex, Vertex>& true_vertex_of, PlanGraphErrors& errors) {
  Edges stood_for;
  for (const auto& [edge, count] : plan.doors) {
    const auto a = true_vertex_of.find(edge.first);
    const auto b = true_vertex_of.find(edge.second);
    if (a == true_vertex_of.end() || b == true_vertex_of.end()) {
      errors.extra += count;
      continue;
    }
    const Edge true_edge = std::minmax(a->second, b->second);
    const auto found = truth.doors.find(true_edge);
    if (found == truth.doors.end()) {
      errors.wrong += count;
      continue;
    }
    stood_for[true_edge] = std::min(count, found->second);
    errors.extra += std::max<std::int64_t>(count - found->second, 0);
  }
  errors.missing = truth.edges;
  for (const auto& entry : stood_for) errors.missing -= entry.second;
}

}  // namespace

PlanGraphErrors plan_graph_errors(const FloorPlan& plan, const FloorPlan& truth,
                                  const std::map<RoomId, RoomId>& true_room_of) {
  const DoorGraph ours = graph_of(plan);
  const DoorGraph theirs = graph_of(truth);
  std::map<Vertex, Vertex> true_vertex_of;
  for (const auto& [room, true_room] : true_room_of) {
    true_vertex_of[ours.vertex_of.at(room)] = theirs.vertex_of.at(true_room);
  }
  PlanGraphErrors errors;
  errors.edges = ours.edges;
  errors.true_edges = theirs.edges;
  count_edits(ours, theirs, true_vertex_of, errors);
  errors.as_matched = errors.edits() == 0 && true_vertex_of.size() == ours.vertex_of.size() &&
                      true_vertex_of.size() == theirs.vertex_of.size();
  errors.isomorphic = errors.as_matched || isomorphic(ours, theirs);
  return errors;
}

}  // namespace roomatlas
