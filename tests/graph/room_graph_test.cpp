// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/graph/room_graph.hpp"

#include <gmock/gmock.h>

#include <boost/range/iterator_range.hpp>
#include <random>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "support/chain_mission.hpp"

namespace roomatlas {
namespace {

using test::chain_mission;
using test::round_the_block;
using test::same_doorway;
using testing::ElementsAre;
using testing::HasSubstr;

std::size_t component_count(const RoomGraph& graph) {
  const auto component = components_of(graph);
  return std::set<int>(component.begin(), component.end()).size();
}

/// A graph of `vertices` ASRs with random edges; parallel ones are allowed, as in a mission.
RoomGraph random_graph(int vertices, int edges, std::mt19937& random) {
  RoomGraph graph;
  for (AsrId id = 1; id <= vertices; ++id) graph.vertices.push_back({id, 0});
  std::uniform_int_distribution<AsrId> any(1, vertices);
  while (edges > 0) {
    const AsrId from = any(random);
    const AsrId to = any(random);
    if (from == to) continue;
    add_edge(graph, same_doorway(from, to));
    --edges;
  }
  return graph;
}

TEST(RoomGraph, HasAVertexForEachAsrAndAnEdgeForEachPassageDriven) {
  const auto asrs = chain_mission(round_the_block(3.0));
  const RoomGraph graph = build_graph(asrs);
  ASSERT_EQ(graph.vertices.size(), 6u);
  for (std::size_t v = 0; v < 6; ++v) EXPECT_EQ(graph.vertices[v].asr, static_cast<AsrId>(v + 1));
  const std::vector<PassageEdge>& edges = graph.edges;
  ASSERT_EQ(edges.size(), 5u);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_EQ(edges[i].from, static_cast<AsrId>(i + 1));
    EXPECT_EQ(edges[i].to, static_cast<AsrId>(i + 2));
    EXPECT_EQ(edges[i].from_from_to, asrs[i].exits.back().frame_from_pivot);
    EXPECT_EQ(edges[i].source, EdgeSource::driven);
    EXPECT_DOUBLE_EQ(edges[i].path_length_m, path_length_m(asrs[i]));
    EXPECT_DOUBLE_EQ(edges[i].turning.absolute_rad, turning(asrs[i]).absolute_rad);
    EXPECT_DOUBLE_EQ(edges[i].turning.signed_rad, turning(asrs[i]).signed_rad);
  }
  EXPECT_NEAR(edges[0].path_length_m, 9.0, 1e-9);
}

TEST(RoomGraph, AnEdgeKnowsWhereItsPoseStarts) {
  const auto visits = round_the_block(0.0);
  const Placement truth = test::true_placement(visits);
  const RoomGraph graph = build_graph(chain_mission(visits));
  ASSERT_EQ(graph.edges.size(), 5u);
  for (const PassageEdge& passage : graph.edges) {
    const Pose2 expected = inverse(truth.at(passage.from)) * truth.at(passage.to);
    EXPECT_LT((passage.from_from_to.position() - expected.position()).norm(), 1e-9);
    EXPECT_NEAR(wrap_angle(passage.from_from_to.theta_rad - expected.theta_rad), 0.0, 1e-9);
  }
}

TEST(RoomGraph, AnExitWithoutItsNeighborGivesNoEdge) {
  auto visits = round_the_block(0.0);
  visits[2].is_linked = false;
  auto asrs = chain_mission(visits);
  asrs.pop_back();  // the store was cut short: the fifth leads nowhere
  const RoomGraph graph = build_graph(asrs);
  EXPECT_EQ(graph.edges.size(), 3u);
  EXPECT_THAT(components_of(graph), ElementsAre(0, 0, 1, 1, 1));
}

TEST(RoomGraph, OfNoMissionIsEmpty) {
  const RoomGraph graph = build_graph({});
  EXPECT_TRUE(graph.edges.empty());
  EXPECT_TRUE(components_of(graph).empty());
  EXPECT_TRUE(cycle_basis(graph).empty());
  EXPECT_EQ(to_dot(graph), "graph rooms {\n  graph [layout=neato, overlap=scale];\n}\n");
}

TEST(RoomGraph, RefusesAnEdgeToAnUnknownAsr) {
  RoomGraph graph = build_graph(chain_mission(round_the_block(0.0)));
  EXPECT_THROW(add_edge(graph, same_doorway(2, 7)), std::out_of_range);
  EXPECT_THROW(add_edge(graph, same_doorway(0, 2)), std::out_of_range);
  EXPECT_EQ(graph.edges.size(), 5u);
}

TEST(RoomGraph, KeepsItsEdgesInTheOrderAdded) {
  RoomGraph graph = build_graph(chain_mission(round_the_block(0.0)));
  add_edge(graph, same_doorway(6, 2));
  add_edge(graph, same_doorway(1, 5));
  const std::vector<PassageEdge>& edges = graph.edges;
  ASSERT_EQ(edges.size(), 7u);
  EXPECT_EQ(edges[5].from, 6);
  EXPECT_EQ(edges[6].from, 1);
}

TEST(CycleBasis, HasEdgesLessVerticesPlusComponentsCycles) {
  std::mt19937 random(5);
  for (int vertices = 1; vertices <= 12; ++vertices) {
    for (int edges = 0; edges <= (vertices > 1 ? 20 : 0); ++edges) {
      const RoomGraph graph = random_graph(vertices, edges, random);
      EXPECT_EQ(cycle_basis(graph).size() + static_cast<std::size_t>(vertices),
                static_cast<std::size_t>(edges) + component_count(graph));
    }
  }
}

TEST(CycleBasis, GoesFromAsrToAsrAlongEdgesAndBackToItsStart) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 50; ++trial) {
    const RoomGraph graph = random_graph(9, 14, random);
    std::set<std::pair<AsrId, AsrId>> joined;
    for (const PassageEdge& edge : graph.edges) {
      joined.insert({edge.from, edge.to});
      joined.insert({edge.to, edge.from});
    }
    for (const auto& cycle : cycle_basis(graph)) {
      EXPECT_GE(cycle.size(), 2u);
      EXPECT_EQ(std::set<AsrId>(cycle.begin(), cycle.end()).size(), cycle.size());
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        EXPECT_TRUE(joined.contains({cycle[i], cycle[(i + 1) % cycle.size()]}));
      }
    }
  }
}

TEST(CycleBasis, FindsTheWayRoundTheBlock) {
  RoomGraph graph = build_graph(chain_mission(round_the_block(0.0)));
  EXPECT_TRUE(cycle_basis(graph).empty());
  add_edge(graph, same_doorway(2, 6));
  const auto cycles = cycle_basis(graph);
  ASSERT_EQ(cycles.size(), 1u);
  EXPECT_THAT(cycles[0], testing::UnorderedElementsAre(2, 3, 4, 5, 6));
}

TEST(Dot, NamesEachAsrAndDrawsEachKindOfEdgeItsOwnWay) {
  auto visits = round_the_block(0.0);
  visits[1].width_m = 0.0;  // an open passage
  RoomGraph graph = build_graph(chain_mission(visits));
  add_edge(graph, same_doorway(2, 6));
  set_rooms(graph, {{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 1}, {6, 2}});
  const std::string dot = to_dot(graph);
  EXPECT_THAT(dot, HasSubstr("1 -- 2 [style=dashed]"));
  EXPECT_THAT(dot, HasSubstr("2 -- 3 [style=solid]"));
  EXPECT_THAT(dot, HasSubstr("2 -- 6 [style=bold]"));
  EXPECT_THAT(dot, HasSubstr("5 [label=\"ASR 5\\nroom 1\"]"));
}

TEST(Dot, IsAHeadAStatementForEachVertexAndEdgeAndAClosingBrace) {
  RoomGraph graph = build_graph(chain_mission(round_the_block(0.0)));
  add_edge(graph, same_doorway(2, 6));
  std::istringstream lines(to_dot(graph));
  std::string kinds;
  for (std::string line; std::getline(lines, line);) {
    if (line == "graph rooms {") {
      kinds += '{';
    } else if (line == "  graph [layout=neato, overlap=scale];") {
      kinds += 'g';
    } else if (std::regex_match(line, std::regex(R"re(  \d+ \[label="[^"]*"\];)re"))) {
      kinds += 'v';
    } else if (std::regex_match(line, std::regex(R"re(  \d+ -- \d+ \[style=[a-z]+\];)re"))) {
      kinds += 'e';
    } else {
      kinds += line;
    }
  }
  EXPECT_EQ(kinds, "{gvvvvvveeeeee}");
}

TEST(SetRooms, WritesTheRoomOfEachAsrIntoItsVertex) {
  RoomGraph graph = build_graph(chain_mission(round_the_block(0.0)));
  set_rooms(graph, {{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 1}, {6, 2}});
  EXPECT_EQ(graph.vertices[4].room, 1);
  EXPECT_EQ(graph.vertices[5].room, 2);
  EXPECT_THROW(set_rooms(graph, {{1, 1}}), std::out_of_range);
}

}  // namespace
}  // namespace roomatlas
