// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/route_graph.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "plans/geojson_geometry.hpp"
#include "plans/route_cells.hpp"

namespace roomatlas {
namespace {

using io::RouteCells;
using io::Way;

constexpr double kStretch = 1.1;  // of the spanner

/// One room's part of the graph: who is joined with whom, and how far.
class RoomWays {
 public:
  void join(std::size_t a, std::size_t b, double length_m) {
    next_[a][b] = length_m;
    next_[b][a] = length_m;
  }
  /// Whether it is no more than so far along what is joined.
  [[nodiscard]] bool are_within(std::size_t from, std::size_t to, double most_m) const {
    std::map<std::size_t, double> known = {{from, 0.0}};
    std::set<std::pair<double, std::size_t>> open = {{0.0, from}};
    while (!open.empty()) {
      const auto [so_far_m, at] = *open.begin();
      if (at == to) return true;
      open.erase(open.begin());
      const auto near = next_.find(at);
      if (near == next_.end()) continue;
      for (const auto& [node, length_m] : near->second) {
        const double far_m = so_far_m + length_m;
        const auto found = known.find(node);
        if (far_m > most_m || (found != known.end() && found->second <= far_m)) continue;
        if (found != known.end()) open.erase({found->second, node});
        known[node] = far_m;
        open.emplace(far_m, node);
      }
    }
    return false;
  }

 private:
  std::map<std::size_t, std::map<std::size_t, double>> next_;
};

class Builder {
 public:
  explicit Builder(const FloorPlan& plan) : plan_(plan), cells_(plan) {}

  RouteGraph build() {
    place_nodes();
    for (const PlanRoom& room : plan_.rooms) join(room);
    say_what_is_left();
    return std::move(graph_);
  }

 private:
  /// Two ends, and how long the way between them is; until it is known, no less than that.
  struct Candidate {
    double length_m = 0.0;
    bool is_known = false;
    std::size_t from = 0;
    std::size_t to = 0;
    bool operator<(const Candidate& other) const {
      return std::tie(length_m, is_known, from, to) <
             std::tie(other.length_m, other.is_known, other.from, other.to);
    }
  };

  static bool leads_to(const PlanDoor& door, const PlanRoom& room) {
    return door.kind != DoorKind::window && (door.room_a == room.id || door.room_b == room.id);
  }

  void place_nodes() {
    for (const PlanRoom& room : plan_.rooms) {
      cells_.enter(room);
      const auto at = cells_.nearest_open(room.label_point);
      if (!at) continue;
      room_nodes_[room.id] = graph_.nodes.size();
      graph_.nodes.push_back({to_millimetre(*at), room.id, {}});
    }
    for (const PlanDoor& door : plan_.doors) {
      if (door.kind == DoorKind::window) continue;
      const Point2 at = to_millimetre((door.jambs.a + door.jambs.b) / 2.0);
      door_nodes_[door.id] = graph_.nodes.size();
      graph_.nodes.push_back({at, {}, door.id});
    }
  }

  /// The room's middle and the doors that a robot can stand in.
  std::vector<std::size_t> ends_of(const PlanRoom& room) const {
    std::vector<std::size_t> ends;
    if (const auto middle = room_nodes_.find(room.id); middle != room_nodes_.end()) {
      ends.push_back(middle->second);
    }
    for (const PlanDoor& door : plan_.doors) {
      if (!leads_to(door, room)) continue;
      const std::size_t node = door_nodes_.at(door.id);
      if (cells_.is_open(graph_.nodes[node].at)) ends.push_back(node);
    }
    return ends;
  }

  /// The greedy spanner of the ways between all ends: the shortest first, and none that is hardly
  /// shorter than what is joined already. Most are told not to be by the straight line between
  /// their ends, and never looked for.
  void join(const PlanRoom& room) {
    cells_.enter(room);
    const std::vector<std::size_t> ends = ends_of(room);
    const auto place = [&](std::size_t node) { return graph_.nodes[node].at; };
    std::set<Candidate> candidates;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t j = i + 1; j < ends.size(); ++j) {
        const double straight_m = (place(ends[j]) - place(ends[i])).norm();
        candidates.insert({straight_m, false, ends[i], ends[j]});
      }
    }
    RoomWays ways;
    std::map<std::pair<std::size_t, std::size_t>, Way> found;
    while (!candidates.empty()) {
      const Candidate next = candidates.extract(candidates.begin()).value();
      if (ways.are_within(next.from, next.to, kStretch * next.length_m)) continue;
      Way& way = found[{next.from, next.to}];
      if (next.is_known) {
        add(next, way, room, ways);
        continue;
      }
      way = cells_.way(place(next.from), place(next.to));
      if (!way.line.empty()) candidates.insert({way.length_m, true, next.from, next.to});
    }
  }

  void add(const Candidate& ends, const Way& way, const PlanRoom& room, RoomWays& ways) {
    std::size_t before = ends.from;
    const Polyline& line = way.line;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const std::size_t node = i + 1 == line.size() ? ends.to : bend(line[i]);
      const double length_m = (graph_.nodes[node].at - graph_.nodes[before].at).norm();
      if (edges_.insert(std::minmax(before, node)).second) {
        graph_.edges.push_back({before, node, room.id, length_m, way.clearance_m});
      }
      ways.join(before, node, length_m);
      before = node;
    }
  }

  std::size_t bend(const Point2& at) {
    const Point2 place = to_millimetre(at);
    const auto [entry, is_new] = bends_.try_emplace({place.x(), place.y()}, graph_.nodes.size());
    if (is_new) graph_.nodes.push_back({place, {}, {}});
    return entry->second;
  }

  /// Nodes without an edge are named instead of kept: a robot cannot be sent there.
  void say_what_is_left() {
    std::vector<bool> is_joined(graph_.nodes.size(), false);
    for (const RouteEdge& edge : graph_.edges) is_joined[edge.from] = is_joined[edge.to] = true;
    for (const PlanRoom& room : plan_.rooms) {
      const auto node = room_nodes_.find(room.id);
      if (node == room_nodes_.end() || !is_joined[node->second]) {
        graph_.rooms_without_way.push_back(room.id);
      }
    }
    std::vector<std::size_t> now(graph_.nodes.size());
    std::vector<RouteNode> kept;
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      now[i] = kept.size();
      if (is_joined[i]) {
        kept.push_back(graph_.nodes[i]);
      } else if (graph_.nodes[i].door) {
        graph_.doors_without_way.push_back(*graph_.nodes[i].door);
      }
    }
    graph_.nodes = std::move(kept);
    for (RouteEdge& edge : graph_.edges) {
      edge.from = now[edge.from];
      edge.to = now[edge.to];
    }
  }

  const FloorPlan& plan_;
  RouteCells cells_;
  RouteGraph graph_;
  std::map<RoomId, std::size_t> room_nodes_;
  std::map<std::int64_t, std::size_t> door_nodes_;
  std::map<std::pair<double, double>, std::size_t> bends_;
  std::set<std::pair<std::size_t, std::size_t>> edges_;
};

}  // namespace

RouteGraph route_graph_of(const FloorPlan& plan) { return Builder(plan).build(); }

}  // namespace roomatlas
