// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "program.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;

/// Two rooms of 4 x 4 m beside each other, with a door of 0.9 m, in cells of 0.1 m.
std::string two_rooms() {
  std::string rows;
  for (int y = 0; y < 44; ++y) {
    for (int x = 0; x < 86; ++x) {
      const bool is_door = y >= 20 && y < 29 && x >= 42 && x < 44;
      const bool is_floor = y >= 2 && y < 42 && ((x >= 2 && x < 42) || (x >= 44 && x < 84));
      rows += is_door || is_floor ? "254 " : "0 ";
    }
    rows += "\n";
  }
  return "P2 86 44 255\n" + rows;
}

TEST(BuildFromMap, WritesThePlanInTheMapsFrame) {
  const Folder folder;
  (void)folder.write("house.pgm", two_rooms());
  const auto map = folder.write(
      "house.yaml", "image: house.pgm\nresolution: 0.1\norigin: [10, 20, 1.5707963267948966]\n");
  const Outcome done = run("build -q " + map.string() + " -o " + (folder / "out").string());
  ASSERT_EQ(done.exit_code, 0) << done.err;
  for (const char* name :
       {"building.gpkg", "plan.svg", "plan.pdf", "plan.png", "rooms.csv", "rooms.graphml",
        "map.yaml", "rooms.yaml", "summary.json", "report.html"}) {
    EXPECT_GT(content_of(folder / "out" / name).size(), 0U) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "trajectory_corrected.tum"));
  const auto plan = nlohmann::json::parse(content_of(folder / "out" / "plan.local.geojson"));
  double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;
  int rooms = 0;
  for (const auto& feature : plan["features"]) {
    if (!feature["properties"].contains("area_m2")) continue;
    ++rooms;
    const auto& rings = feature["geometry"]["coordinates"];
    const auto& ring = feature["geometry"]["type"] == "MultiPolygon" ? rings[0][0] : rings[0];
    for (const auto& point : ring) {
      low_x = std::min(low_x, point[0].get<double>());
      high_x = std::max(high_x, point[0].get<double>());
      low_y = std::min(low_y, point[1].get<double>());
      high_y = std::max(high_y, point[1].get<double>());
    }
  }
  EXPECT_EQ(rooms, 2);
  // A quarter turn: the map's x runs along the building's y.
  EXPECT_NEAR(low_x, 10.0 - 4.2, 0.1);
  EXPECT_NEAR(high_x, 10.0 - 0.2, 0.1);
  EXPECT_NEAR(low_y, 20.0 + 0.2, 0.1);
  EXPECT_NEAR(high_y, 20.0 + 8.4, 0.1);
}

TEST(BuildFromMap, TheSameMapGivesTheSameBytesAndKeepsNames) {
  const Folder folder;
  const std::string map = folder.write("house.pgm", two_rooms()).string();
  const std::string build = "build -q --resolution 0.1 " + map + " -o ";
  ASSERT_EQ(run(build + (folder / "a").string()).exit_code, 0);
  ASSERT_EQ(run(build + (folder / "b").string()).exit_code, 0);
  for (const char* name : {"building.gpkg", "plan.svg", "summary.json"}) {
    EXPECT_EQ(content_of(folder / "a" / name), content_of(folder / "b" / name)) << name;
  }
  ASSERT_EQ(run("rename " + (folder / "a/building.gpkg").string() + " 2 Library").exit_code, 0);
  ASSERT_EQ(run(build + (folder / "a").string()).exit_code, 0);
  EXPECT_THAT(content_of(folder / "a" / "rooms.csv"), HasSubstr("Library"));
}

TEST(BuildFromMap, WhatIsMissingIsSaidWithItsExitCode) {
  const Folder folder;
  const std::string out = " -o " + (folder / "out").string();
  const std::string bare = folder.write("bare.pgm", two_rooms()).string();
  const Outcome no_size = run("build " + bare + out);
  EXPECT_EQ(no_size.exit_code, 2);
  EXPECT_THAT(no_size.err, HasSubstr("--resolution"));
  const std::string black = folder.write("black.pgm", "P2 2 1 255\n0 0\n").string();
  EXPECT_EQ(run("build --resolution 0.05 " + black + out).exit_code, 4);
  const std::string yaml =
      folder.write("a.yaml", "image: none.pgm\nresolution: 1\norigin: [0, 0, 0]\n").string();
  EXPECT_EQ(run("build " + yaml + out).exit_code, 3);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace roomatlas::test
