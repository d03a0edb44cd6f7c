// SPDX-License-Identifier: GPL-3.0-or-later
// What others style and script the drawing by.
#include "draw/flat_fixture.hpp"

#include <gmock/gmock.h>
#include <pugixml.hpp>

#include <algorithm>
#include <set>

namespace roomatlas {
namespace {

using test::flat;
using test::moved;

class Drawn {
 public:
  explicit Drawn(const FloorPlan& plan) {
    EXPECT_TRUE(document_.load_string(draw_plan(plan, {}, {}).c_str()));
  }
  [[nodiscard]] std::vector<pugi::xml_node> all(const std::string& path) const {
    std::vector<pugi::xml_node> nodes;
    for (const pugi::xpath_node& found : document_.select_nodes(path.c_str())) {
      nodes.push_back(found.node());
    }
    return nodes;
  }

 private:
  pugi::xml_document document_;
};

std::vector<std::string> ids_of(const Drawn& drawn, const std::string& layer) {
  std::vector<std::string> ids;
  for (const pugi::xml_node& node : drawn.all(layer + "//*[@id]")) {
    ids.push_back(node.attribute("id").value());
  }
  return ids;
}

TEST(DrawingIds, IdsAreUniqueAndTheSameInAnotherFrameAndWithOtherNames) {
  const std::vector<std::string> all = ids_of(Drawn(flat()), "");
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
  FloorPlan other = moved(flat(), {40.0, -7.0, 0.2});
  for (PlanRoom& room : other.rooms) room.name = "Suite " + room.name;
  std::rotate(other.doors.begin(), other.doors.begin() + 1, other.doors.end());
  for (const char* layer : {"rooms", "doors", "walls", "furniture"}) {
    const std::string group = "//g[@id='" + std::string(layer) + "']";
    EXPECT_THAT(ids_of(Drawn(other), group),
                testing::UnorderedElementsAreArray(ids_of(Drawn(flat()), group)));
    EXPECT_FALSE(ids_of(Drawn(flat()), group).empty()) << layer;
  }
}

TEST(DrawingIds, WhatHasAnIdInItsLayersHasATitle) {
  const Drawn drawn(flat());
  for (const char* layer : {"rooms", "doors", "walls", "furniture"}) {
    for (const pugi::xml_node& node : drawn.all("//g[@id='" + std::string(layer) + "']/*[@id]")) {
      EXPECT_STREQ(node.first_child().name(), "title") << node.attribute("id").value();
    }
  }
  const auto title = [&](const std::string& id) {
    return std::string(drawn.all("//*[@id='" + id + "']").front().child("title").text().get());
  };
  EXPECT_EQ(title("door-1-3"), "door between 1 and Living room, 0.90 m");
  EXPECT_EQ(title("room-2"), "Kitchen, room, 7.6\u00a0m\u00b2");
}

}  // namespace
}  // namespace roomatlas
