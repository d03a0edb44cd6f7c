// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/rmf_building.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "roomatlas/io/plans/route_graph.hpp"
#include "support/shipped_world.hpp"

namespace roomatlas {
namespace {

using Json = nlohmann::json;

/// The level's lists: each entry is a line of flow style, which is JSON.
std::map<std::string, std::vector<Json>> lists_of(const std::string& yaml) {
  std::map<std::string, std::vector<Json>> lists;
  std::istringstream lines(yaml);
  std::string name;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("      - ")) {
      lists[name].push_back(Json::parse(line.substr(8)));
    } else if (line.starts_with("    ") && line.ends_with(":")) {
      name = line.substr(4, line.size() - 5);
    }
  }
  return lists;
}

/// A parameter as the editor reads it: its type by number, then a value of that type.
bool is_typed(const Json& value) {
  if (!value.is_array() || value.size() != 2) return false;
  switch (value[0].get<int>()) {
    case 1:
      return value[1].is_string();
    case 2:
      return value[1].is_number_integer();
    case 3:
      return value[1].is_number();
    case 4:
      return value[1].is_boolean();
    default:
      return false;
  }
}

TEST(RmfBuilding, RefersToItsVerticesByTypedEdges) {
  const FloorPlan plan = test::shipped_world("eight_rooms");
  auto lists = lists_of(rmf_building_yaml(plan));
  const std::vector<Json>& vertices = lists["vertices"];
  for (const Json& vertex : vertices) {
    ASSERT_EQ(vertex.size(), 5U);
    EXPECT_TRUE(vertex[3].is_string());
  }
  for (const char* name : {"walls", "doors", "lanes"}) {
    EXPECT_FALSE(lists[name].empty()) << name;
    for (const Json& edge : lists[name]) {
      EXPECT_LT(edge[0].get<std::size_t>(), vertices.size());
      EXPECT_LT(edge[1].get<std::size_t>(), vertices.size());
      EXPECT_NE(edge[0], edge[1]);
      for (const auto& entry : edge[2].items()) EXPECT_TRUE(is_typed(entry.value())) << entry.key();
    }
  }
  for (const Json& floor : lists["floors"]) {
    EXPECT_GE(floor["vertices"].size(), 3U);
    for (const Json& vertex : floor["vertices"])
      EXPECT_LT(vertex.get<std::size_t>(), vertices.size());
  }
}

TEST(RmfBuilding, HasThePlansSizesInMetres) {
  const FloorPlan plan = test::shipped_world("eight_rooms");
  auto lists = lists_of(rmf_building_yaml(plan));
  const auto at = [&](const Json& index) {
    const Json& vertex = lists["vertices"][index.get<std::size_t>()];
    return Point2(vertex[0].get<double>(), vertex[1].get<double>());
  };
  ASSERT_EQ(lists["doors"].size(), plan.doors.size());
  for (std::size_t i = 0; i < plan.doors.size(); ++i) {
    const Json& door = lists["doors"][i];
    EXPECT_LT((at(door[0]) - plan.doors[i].jambs.a).norm(), 2e-3);
    EXPECT_LT((at(door[1]) - plan.doors[i].jambs.b).norm(), 2e-3);
  }
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    Ring ring;
    for (const Json& vertex : lists["floors"][i]["vertices"]) ring.push_back(at(vertex));
    EXPECT_NEAR(signed_area(ring), signed_area(plan.rooms[i].parts[0].outer), 0.05);
  }
  EXPECT_EQ(lists["lanes"].size(), route_graph_of(plan).edges.size());
}

TEST(RmfBuilding, RoomsOfOneNameStayApart) {
  FloorPlan plan = test::shipped_world("two_rooms");
  for (PlanRoom& room : plan.rooms) room.name = "Lab: \"1\"";
  auto lists = lists_of(rmf_building_yaml(plan));
  std::vector<std::string> names;
  for (const Json& vertex : lists["vertices"]) {
    if (vertex[3] != "") names.push_back(vertex[3]);
  }
  EXPECT_THAT(names, ::testing::ElementsAre("Lab: \"1\"", "Lab: \"1\" (2)"));
}

}  // namespace
}  // namespace roomatlas
