// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "program.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;

const std::string kWorlds = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/";

std::vector<std::string> file_names(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Runs `simulate` with these arguments into a folder; the exit code must be 0.
Outcome simulated(const std::string& arguments, const std::filesystem::path& out) {
  const Outcome outcome = run("-q --json simulate " + arguments + " -o " + out.string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome;
}

bool same_files(const std::filesystem::path& a, const std::filesystem::path& b) {
  const auto names = file_names(a);
  return names == file_names(b) && std::all_of(names.begin(), names.end(), [&](const auto& name) {
           return content_of(a / name) == content_of(b / name);
         });
}

/// A room of 4 m x 4 m with a wall around it, and whatever else is given.
std::string world_of(const std::string& more_features, const std::string& units = "m") {
  return R"({"type":"FeatureCollection","roomatlas":{"schema":"plan","version":1,"units":")" +
         units + R"(","title":"Test"},"features":[
    {"type":"Feature","properties":{"kind":"room","id":1},"geometry":{"type":"Polygon",
     "coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]}},
    {"type":"Feature","properties":{"kind":"wall"},"geometry":{"type":"Polygon",
     "coordinates":[[[-0.2,-0.2],[4.2,-0.2],[4.2,4.2],[-0.2,4.2],[-0.2,-0.2]],
                    [[0,0],[0,4],[4,4],[4,0],[0,0]]]}})" +
         more_features + "]}";
}

/// The refusal must be one line on stderr, and no mission may be left behind.
void expect_refusal(const std::string& world, const std::string& flags, int exit_code,
                    const std::string& mentions) {
  const Folder folder;
  const auto file = folder.write("world.geojson", world);
  const Outcome outcome =
      run("-q simulate " + file.string() + " " + flags + " -o " + (folder / "out").string());
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_NE(outcome.err.find(mentions), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "mission.clf"));
}

TEST(Simulate, TheSameSeedGivesTheSameBytesAndAnotherSeedOthers) {
  const Folder folder;
  simulated(kWorlds + "two_rooms.geojson --seed 3", folder / "a");
  simulated(kWorlds + "two_rooms.geojson --seed 3", folder / "b");
  simulated(kWorlds + "two_rooms.geojson --seed 4", folder / "c");
  EXPECT_EQ(file_names(folder / "a"),
            (std::vector<std::string>{"mission.clf", "truth.geojson", "truth.tum"}));
  EXPECT_TRUE(same_files(folder / "a", folder / "b"));
  EXPECT_NE(content_of(folder / "a" / "mission.clf"), content_of(folder / "c" / "mission.clf"));
}

/// Of the true plan in a folder: pieces of furniture, and doors that stand open.
std::pair<std::int64_t, std::int64_t> furnishing(const std::filesystem::path& folder) {
  const Json truth = Json::parse(content_of(folder / "truth.geojson"));
  std::pair<std::int64_t, std::int64_t> found;
  for (const Json& feature : truth["features"]) {
    if (feature["properties"]["kind"] == "furniture") ++found.first;
    if (feature["properties"].contains("leaf")) ++found.second;
  }
  return found;
}

TEST(Simulate, FurnitureAndPeopleComeBySeedAndFurnitureIsInTheTruth) {
  const Folder folder;
  const std::string world = kWorlds + "two_rooms.geojson --sensor laser --max-time 30 ";
  simulated(world + "--furnish 3 --people 2", folder / "a");
  simulated(world + "--furnish 3 --people 2", folder / "b");
  simulated(world + "--furnish 3", folder / "alone");
  simulated(world, folder / "empty");
  EXPECT_TRUE(same_files(folder / "a", folder / "b"));
  EXPECT_GE(furnishing(folder / "a").first, 8);
  EXPECT_EQ(furnishing(folder / "empty"), std::pair(std::int64_t{0}, std::int64_t{0}));
  EXPECT_EQ(content_of(folder / "a" / "truth.geojson"),
            content_of(folder / "alone" / "truth.geojson"));
  EXPECT_NE(content_of(folder / "a" / "mission.clf"), content_of(folder / "alone" / "mission.clf"));
}

TEST(Simulate, ARandomWorldComesFromItsSeedAndIsTheTruth) {
  const Folder folder;
  const std::string world = "--random-world 5 --world-kind wings --world-rooms 6 --max-time 20 ";
  simulated(world, folder / "a");
  simulated(world, folder / "b");
  simulated("--random-world 6 --world-kind wings --world-rooms 6 --max-time 20", folder / "c");
  EXPECT_TRUE(same_files(folder / "a", folder / "b"));
  EXPECT_NE(content_of(folder / "a" / "truth.geojson"), content_of(folder / "c" / "truth.geojson"));
  simulated(world + "--tour --furnish 1", folder / "tour");
  const Json truth = Json::parse(content_of(folder / "tour" / "truth.geojson"));
  const auto rooms =
      std::count_if(truth["features"].begin(), truth["features"].end(),
                    [](const Json& feature) { return feature["properties"]["kind"] == "room"; });
  EXPECT_GE(rooms, 3);
}

TEST(Simulate, ATourEndsAtItsTime) {
  const Folder folder;
  simulated(kWorlds + "eight_rooms.geojson --tour --max-time 60", folder / "out");
  const std::string poses = content_of(folder / "out" / "truth.tum");
  const auto lines = std::count(poses.begin(), poses.end(), '\n');
  EXPECT_GT(lines, 400);
  EXPECT_LE(lines, 602);
}

TEST(Simulate, WorldsThatAreNoneOrSeveralAreRefused) {
  const Folder folder;
  const std::string out = " -o " + (folder / "out").string();
  const Outcome both = run("-q simulate " + kWorlds + "two_rooms.geojson --random-world 1" + out);
  EXPECT_NE(both.err.find("--random-world SEED"), std::string::npos) << both.err;
  const Outcome kind = run("-q simulate --random-world 1 --world-kind castle" + out);
  EXPECT_NE(kind.err.find("offices"), std::string::npos) << kind.err;
  const Outcome rooms = run("-q simulate " + kWorlds + "two_rooms.geojson --world-rooms 5" + out);
  EXPECT_NE(rooms.err.find("--world-rooms"), std::string::npos) << rooms.err;
  for (const Outcome& outcome : {both, kind, rooms}) EXPECT_EQ(outcome.exit_code, 2);
}

TEST(Simulate, FurnitureKeepsClearOfADrive) {
  const Folder folder;
  const Outcome outcome =
      run("-q simulate " + kWorlds + "eight_rooms.geojson --furnish 1 --drive " + kWorlds +
          "eight_rooms.drive -o " + (folder / "out").string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto [pieces, leaves] = furnishing(folder / "out");
  EXPECT_GT(pieces, 50);
  EXPECT_GT(leaves, 2);
}

TEST(Simulate, ATourIsDrivenInTheFurnishedWorld) {
  const Folder folder;
  const std::string world = kWorlds + "eight_rooms.geojson --furnish 1 --tour --speed 2 ";
  const Outcome outcome = run("-q simulate " + world + "-o " + (folder / "out").string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_GT(content_of(folder / "out" / "truth.tum").size(), 10000U);
  const Outcome both = run("-q simulate " + world + "--drive " + kWorlds + "eight_rooms.drive -o " +
                           (folder / "both").string());
  EXPECT_EQ(both.exit_code, 2) << both.err;
}

TEST(Simulate, AWorldWithoutRoomsIsNotFurnished) {
  const std::string world = R"({"type":"FeatureCollection","roomatlas":{"schema":"plan","version":1,
    "units":"m"},"features":[{"type":"Feature","properties":{"kind":"wall"},"geometry":{
    "type":"Polygon","coordinates":[[[-0.2,-0.2],[4.2,-0.2],[4.2,4.2],[-0.2,4.2],[-0.2,-0.2]],
                                    [[0,0],[0,4],[4,4],[4,0],[0,0]]]}}]})";
  expect_refusal(world, "--start 2,2,0 --furnish 1", 3, "no rooms");
}

TEST(Simulate, AnExploringRobotReportsWhatItEnteredAndTouched) {
  const Folder folder;
  for (const char* belief : {"truth", "odometry"}) {
    const Json report = Json::parse(
        simulated(kWorlds + "two_rooms.geojson --explore-on " + belief, folder / belief).out);
    EXPECT_TRUE(report.contains("collisions")) << report;
    EXPECT_EQ(report["rooms"], 2);
    EXPECT_GT(report["duration_s"].get<double>(), 10.0);
    EXPECT_LE(report["duration_s"].get<double>(), 21600.1);
  }
}

TEST(Simulate, AClosedOffRoomIsSaidAndTheRestExplored) {
  const Folder folder;
  const auto world = folder.write("world.geojson", world_of(R"(,
    {"type":"Feature","properties":{"kind":"room","id":2},"geometry":{"type":"Polygon",
     "coordinates":[[[4.4,0],[8,0],[8,4],[4.4,4],[4.4,0]]]}},
    {"type":"Feature","properties":{"kind":"room","id":3},"geometry":{"type":"Polygon",
     "coordinates":[[[-4,0],[-0.4,0],[-0.4,4],[-4,4],[-4,0]]]}},
    {"type":"Feature","properties":{"kind":"door","id":1,"width_m":0.9,
     "jambs":[[4.3,1],[4.3,1.9]],"rooms":[1,2]},"geometry":{"type":"Polygon",
     "coordinates":[[[4.2,1],[4.4,1],[4.4,1.9],[4.2,1.9],[4.2,1]]]}})"));
  const Outcome outcome =
      run("--json simulate " + world.string() + " -o " + (folder / "out").string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("closed off"), std::string::npos) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["entered"], 1);
}

TEST(Simulate, AWorldThatCannotBeDrivenThroughGetsOneLine) {
  expect_refusal(world_of("", "ft"), "", 3, "ft");
  expect_refusal(world_of(R"(,{"type":"Feature","properties":{"kind":"room","id":2},
    "geometry":{"type":"Polygon","coordinates":[[[3,0],[8,0],[8,4],[3,4],[3,0]]]}})"),
                 "", 3, "overlaps room 2");
  expect_refusal(world_of(""), "--start 4.1,2,0", 3, "wall");
  expect_refusal(world_of(""), "--start 40,2,0", 3, "outside of all rooms");
}

/// The bytes but the name of the mission's file, which drawings show.
std::string without_name(std::string text) {
  for (const std::string name : {"mission.clf", "mission.bag", "mission.mcap", "mission.db3"}) {
    for (std::size_t at; (at = text.find(name)) != std::string::npos;) text.erase(at, name.size());
  }
  return text;
}

TEST(Simulate, RecordingsMapToTheSameBytesAsTheCarmenLog) {
  for (const std::string sensor : {"laser", "sonar"}) {
    const Folder folder;
    for (const std::string format : {"clf", "bag", "mcap", "db3"}) {
      const auto out = folder / format;
      simulated(kWorlds + "two_rooms.geojson --sensor " + sensor + " --format " + format, out);
      const Outcome built = run("-q build " + (out / ("mission." + format)).string() + " -o " +
                                (out / "plan").string());
      ASSERT_EQ(built.exit_code, 0) << built.err;
      for (const char* name : {"plan.local.geojson", "plan.svg", "trajectory_corrected.tum",
                               "graph.g2o", "rooms.csv", "map.pgm"}) {
        EXPECT_TRUE(without_name(content_of(out / "plan" / name)) ==
                    without_name(content_of(folder / "clf" / "plan" / name)))
            << sensor << " " << format << " " << name;
      }
    }
  }
}

TEST(Simulate, ARandomBuildingIsAStoreThatAssembleTakes) {
  const Folder folder;
  simulated("--random-rooms 12 --seed 5", folder / "a");
  EXPECT_EQ(file_names(folder / "a"),
            (std::vector<std::string>{"building.gpkg", "truth.geojson", "truth.tum"}));
  const Json truth = Json::parse(content_of(folder / "a" / "truth.geojson"));
  const auto& features = truth["features"];
  EXPECT_EQ(std::count_if(features.begin(), features.end(),
                          [](const Json& feature) {
                            const std::string kind = feature["properties"]["kind"];
                            return kind == "room" || kind == "corridor" || kind == "hall";
                          }),
            12);
  const Outcome assembled = run("-q assemble " + (folder / "a" / "building.gpkg").string());
  EXPECT_EQ(assembled.exit_code, 0) << assembled.err;
  const Outcome judged = run("-q --json evaluate " + (folder / "a" / "building.gpkg").string() +
                             " --truth " + (folder / "a" / "truth.geojson").string());
  ASSERT_EQ(judged.exit_code, 0) << judged.err;
  EXPECT_EQ(Json::parse(judged.out)["plans"][0]["plan"]["true_rooms"], 12);
}

TEST(Simulate, ARandomBuildingOfTheSameSeedHasTheSameBytes) {
  const Folder folder;
  simulated("--random-rooms 12 --seed 5", folder / "a");
  simulated("--random-rooms 12 --seed 5", folder / "b");
  simulated("--random-rooms 12 --seed 6", folder / "c");
  EXPECT_TRUE(same_files(folder / "a", folder / "b"));
  EXPECT_NE(content_of(folder / "a" / "truth.tum"), content_of(folder / "c" / "truth.tum"));
}

TEST(Simulate, EitherAWorldOrANumberOfRoomsIsAskedFor) {
  const Folder folder;
  const std::string out = " -o " + (folder / "out").string();
  EXPECT_EQ(run("-q simulate" + out).exit_code, 2);
  EXPECT_EQ(run("-q simulate " + kWorlds + "two_rooms.geojson --random-rooms 3" + out).exit_code,
            2);
  const Outcome none = run("-q simulate --random-rooms 0" + out);
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("--random-rooms: expected 1 or more"), std::string::npos) << none.err;
}

}  // namespace
}  // namespace roomatlas::test
