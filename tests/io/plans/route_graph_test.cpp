// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/route_graph.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <numeric>
#include "support/shipped_world.hpp"

namespace roomatlas {
namespace {

using Json = nlohmann::json;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Polygon box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

/// An L of 2 m wide arms around a closed block, a door of 0.9 m at each end.
FloorPlan corner() {
  FloorPlan plan;
  const Polygon floor{{{0, 0}, {8, 0}, {8, 2}, {2, 2}, {2, 8}, {0, 8}}, {}};
  plan.rooms = {{7, "L", RoomKind::corridor, {floor}, 28.0, {1, 1}, {}}};
  // Doors are notches of the free space, as in a merged plan.
  Polygon walls;
  walls.outer = {{-0.2, -0.2}, {8.2, -0.2}, {8.2, 0.5}, {8, 0.5},   {8, 0},
                 {0, 0},       {0, 8},      {0.5, 8},   {0.5, 8.2}, {-0.2, 8.2}};
  const Polygon block{
      {{8, 1.4}, {8.2, 1.4}, {8.2, 8.2}, {1.4, 8.2}, {1.4, 8}, {2, 8}, {2, 2}, {8, 2}}, {}};
  plan.walls = {walls, block};
  const auto door = [](std::int64_t id, const Segment2& jambs, const Polygon& opening) {
    return PlanDoor{id, jambs, 0.9, opening.outer, 7, std::nullopt};
  };
  plan.doors = {door(1, {{8.1, 0.5}, {8.1, 1.4}}, box(8, 0.5, 8.2, 1.4)),
                door(2, {{0.5, 8.1}, {1.4, 8.1}}, box(0.5, 8, 1.4, 8.2))};
  return plan;
}

/// Walked in steps of 1 cm against every body of the plan.
double least_distance(const FloorPlan& plan, const Segment2& line) {
  std::vector<Polygon> bodies = outlines_of(plan.furniture);
  bodies.insert(bodies.end(), plan.walls.begin(), plan.walls.end());
  const int steps = static_cast<int>((line.b - line.a).norm() / 0.01) + 1;
  double least = 1e9;
  for (int i = 0; i <= steps; ++i) {
    const Point2 at = line.a + (line.b - line.a) * (1.0 * i / steps);
    for (const Polygon& body : bodies) {
      if (contains(body, at)) return -1.0;
      least = std::min(least, distance_to_boundary(body.outer, at));
      for (const Ring& hole : body.holes) least = std::min(least, distance_to_boundary(hole, at));
    }
  }
  return least;
}

/// How many parts the graph falls into.
std::size_t parts(const RouteGraph& graph) {
  std::vector<std::size_t> of(graph.nodes.size());
  std::iota(of.begin(), of.end(), 0U);
  std::size_t count = of.size();
  for (const RouteEdge& edge : graph.edges) {
    const std::size_t a = of[edge.from];
    const std::size_t b = of[edge.to];
    if (a == b) continue;
    --count;
    std::replace(of.begin(), of.end(), a, b);
  }
  return count;
}

class RouteGraphOfWorld : public testing::TestWithParam<const char*> {};

TEST_P(RouteGraphOfWorld, RunsThroughAllDoorsAndNoWall) {
  const FloorPlan plan = test::shipped_world(GetParam());
  const RouteGraph graph = route_graph_of(plan);
  EXPECT_EQ(parts(graph), 1U);
  EXPECT_THAT(graph.rooms_without_way, IsEmpty());
  EXPECT_THAT(graph.doors_without_way, IsEmpty());
  ASSERT_GE(graph.nodes.size(), plan.rooms.size() + plan.doors.size());
  for (const RouteEdge& edge : graph.edges) {
    const Segment2 line{graph.nodes[edge.from].at, graph.nodes[edge.to].at};
    EXPECT_GT(least_distance(plan, line), 0.05) << line.a.transpose() << " " << line.b.transpose();
    EXPECT_NEAR(edge.length_m, (line.b - line.a).norm(), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, RouteGraphOfWorld,
                         testing::Values("two_rooms", "eight_rooms", "nine_rooms",
                                         "slanted_and_curved", "afit_floor"));

TEST(RouteGraph, TurnsAtTheInnerCornerOfAnL) {
  const FloorPlan plan = corner();
  const RouteGraph graph = route_graph_of(plan);
  EXPECT_EQ(parts(graph), 1U);
  // From door to door about the block's corner at (2, 2), by relaxing every edge often enough.
  std::vector<double> from_first_m(graph.nodes.size(), 1e9);
  std::size_t last = 0;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    if (graph.nodes[i].door == 1) from_first_m[i] = 0.0;
    if (graph.nodes[i].door == 2) last = i;
  }
  for (std::size_t round = 0; round < graph.nodes.size(); ++round) {
    for (const RouteEdge& edge : graph.edges) {
      double& a = from_first_m[edge.from];
      double& b = from_first_m[edge.to];
      a = std::min(a, b + edge.length_m);
      b = std::min(b, a + edge.length_m);
    }
  }
  for (const RouteEdge& edge : graph.edges) {
    EXPECT_GT(least_distance(plan, {graph.nodes[edge.from].at, graph.nodes[edge.to].at}), 0.05);
  }
  const double shortest_m = 2.0 * (Point2(8.1, 0.95) - Point2(2, 2)).norm();
  EXPECT_GT(from_first_m[last], shortest_m);
  EXPECT_LT(from_first_m[last], 1.15 * shortest_m);
}

TEST(RouteGraph, NamesDoorsAndRoomsThatNothingLeadsTo) {
  FloorPlan plan = corner();
  plan.furniture = {{box(7, 0, 8, 2), FurnitureKind::free_standing},
                    {box(0, 6, 2, 7), FurnitureKind::against_wall}};
  const RouteGraph graph = route_graph_of(plan);
  EXPECT_THAT(graph.edges, IsEmpty());
  EXPECT_THAT(graph.nodes, IsEmpty());
  EXPECT_THAT(graph.rooms_without_way, ElementsAre(7));
  EXPECT_THAT(graph.doors_without_way, ElementsAre(1, 2));
}

TEST(RouteGraph, GoesRoundFurniture) {
  FloorPlan plan = corner();
  plan.furniture = {{box(3, 0, 4, 1.2), FurnitureKind::against_wall}};
  const RouteGraph graph = route_graph_of(plan);
  EXPECT_EQ(parts(graph), 1U);
  for (const RouteEdge& edge : graph.edges) {
    EXPECT_GT(least_distance(plan, {graph.nodes[edge.from].at, graph.nodes[edge.to].at}), 0.05);
  }
}

TEST(RouteGraph, WindowsAreNoWay) {
  FloorPlan plan = corner();
  plan.doors[0].kind = DoorKind::window;
  const RouteGraph graph = route_graph_of(plan);
  for (const RouteNode& node : graph.nodes) EXPECT_NE(node.door, 1);
  EXPECT_THAT(graph.doors_without_way, IsEmpty());
}

/// As nav2's loader reads it: nodes by id first, then edges that refer to them.
TEST(Nav2Route, HasNodesAndDirectedEdgesAsTheRouteServerLoadsThem) {
  const FloorPlan plan = test::shipped_world("eight_rooms");
  const Json graph = Json::parse(nav2_route_geojson(plan));
  std::map<unsigned, Json> nodes;
  std::set<unsigned> ids;
  std::set<std::pair<unsigned, unsigned>> ways;
  for (const Json& feature : graph["features"]) {
    const Json& properties = feature["properties"];
    EXPECT_TRUE(ids.insert(properties["id"].get<unsigned>()).second);
    for (const auto& entry : properties["metadata"].items()) {
      EXPECT_FALSE(entry.value().is_null() || entry.value().is_object()) << entry.key();
    }
    if (feature["geometry"]["type"] == "Point") {
      EXPECT_EQ(properties["frame"], "map");
      nodes[properties["id"]] = feature["geometry"]["coordinates"];
      continue;
    }
    EXPECT_EQ(feature["geometry"]["type"], "MultiLineString");
    const Json& line = feature["geometry"]["coordinates"][0];
    EXPECT_EQ(line[0], nodes.at(properties["startid"]));
    EXPECT_EQ(line[1], nodes.at(properties["endid"]));
    EXPECT_GT(properties["cost"].get<float>(), 0.0F);
    EXPECT_TRUE(properties["overridable"].get<bool>());
    ways.emplace(properties["startid"], properties["endid"]);
  }
  for (const auto& [from, to] : ways) EXPECT_TRUE(ways.contains({to, from}));
  EXPECT_FALSE(ways.empty());
}

}  // namespace
}  // namespace roomatlas
