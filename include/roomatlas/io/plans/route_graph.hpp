// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// A place that robots drive to or turn at, building metres.
struct RouteNode {
  Point2 at = Point2::Zero();
  std::optional<RoomId> room;        ///< of which it is the middle
  std::optional<std::int64_t> door;  ///< in the middle of which it lies; a bend has neither
};

/// A straight stretch that is driven both ways.
struct RouteEdge {
  std::size_t from = 0;  ///< index of a node
  std::size_t to = 0;
  RoomId room = 0;  ///< that it runs through
  double length_m = 0.0;
  double clearance_m = 0.0;  ///< to what is not free, at its narrowest; to a cell of 0.05 m
};

/// Ways through a plan: nodes at room middles, at doors and passages, and where a way between them
/// turns; edges through what is free, never nearer than 0.05 m to walls and furniture.
struct RouteGraph {
  std::vector<RouteNode> nodes;  ///< rooms, then doors in the plan's order, then bends
  std::vector<RouteEdge> edges;
  std::vector<RoomId> rooms_without_way;        ///< nothing leads from a door to their middle
  std::vector<std::int64_t> doors_without_way;  ///< too narrow, obstructed, or of no room
};

/// The ways of each room between its middle and its doors, as a greedy spanner of shortest ways
/// (Althöfer et al. 1993, stretch 1.1): a way is left out where the others are at most a tenth
/// longer. Windows are no way. Throws InputError for a plan of more than 2^28 cells of 0.05 m.
[[nodiscard]] RouteGraph route_graph_of(const FloorPlan& plan);

/// The graph as GeoJSON for nav2's route server, in the frame `map` of the nav2 map of the plan.
/// Each edge stands there twice, once for each way; docs/formats.md has the properties.
[[nodiscard]] std::string nav2_route_geojson(const FloorPlan& plan);

}  // namespace roomatlas
