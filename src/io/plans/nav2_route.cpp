// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "plans/geojson_geometry.hpp"
#include "roomatlas/io/plans/route_graph.hpp"
#include "text/json.hpp"

namespace roomatlas {
namespace {

constexpr const char* kFrame = "map";  // of the nav2 map beside it

Json feature_of(Json properties, const char* type, Json coordinates) {
  return {{"type", "Feature"},
          {"properties", std::move(properties)},
          {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}}};
}

/// What nav2 passes on to its plugins: numbers, texts and lists of them, no null.
Json metadata_of(const FloorPlan& plan, const RouteNode& node) {
  Json metadata = {{"kind", "bend"}};
  for (const PlanRoom& room : plan.rooms) {
    if (node.room != room.id) continue;
    metadata = {{"kind", to_string(room.kind)}, {"room", room.id}, {"name", room.name}};
  }
  for (const PlanDoor& door : plan.doors) {
    if (node.door != door.id) continue;
    Json rooms = Json::array();
    if (door.room_a) rooms.push_back(*door.room_a);
    if (door.room_b) rooms.push_back(*door.room_b);
    metadata = {{"kind", to_string(door.kind)},
                {"door", door.id},
                {"width_m", to_millimetre(door.width_m)},
                {"rooms", std::move(rooms)}};
  }
  return metadata;
}

Json edge_of(const RouteGraph& graph, const RouteEdge& edge, std::size_t id, bool is_back) {
  const std::size_t from = is_back ? edge.to : edge.from;
  const std::size_t to = is_back ? edge.from : edge.to;
  Json properties = {{"id", id},
                     {"startid", from + 1},
                     {"endid", to + 1},
                     {"cost", to_millimetre(edge.length_m)},
                     {"overridable", true},
                     {"metadata",
                      {{"room", edge.room},
                       {"length_m", to_millimetre(edge.length_m)},
                       {"clearance_m", to_millimetre(edge.clearance_m)}}}};
  return feature_of(
      std::move(properties), "MultiLineString",
      Json::array({Json::array({to_json(graph.nodes[from].at), to_json(graph.nodes[to].at)})}));
}

}  // namespace

std::string nav2_route_geojson(const FloorPlan& plan) {
  const RouteGraph graph = route_graph_of(plan);
  const Json header = {{"schema", "nav2 route graph"},
                       {"title", plan.title},
                       {"rooms_without_way", graph.rooms_without_way},
                       {"doors_without_way", graph.doors_without_way}};
  std::string text =
      "{\"type\":\"FeatureCollection\",\n\"name\":\"graph\",\n\"roomatlas\":" + compact(header) +
      ",\n\"features\":[";
  const char* separator = "\n";
  const auto add = [&](const Json& feature) {
    text += separator + compact(feature);
    separator = ",\n";
  };
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    add(feature_of(
        {{"id", i + 1}, {"frame", kFrame}, {"metadata", metadata_of(plan, graph.nodes[i])}},
        "Point", to_json(graph.nodes[i].at)));
  }
  // Ids of edges go on behind those of nodes, as in nav2's own graphs.
  std::size_t id = graph.nodes.size() + 1;
  for (const RouteEdge& edge : graph.edges) {
    add(edge_of(graph, edge, id++, false));
    add(edge_of(graph, edge, id++, true));
  }
  return text + "\n]}\n";
}

}  // namespace roomatlas
