// SPDX-License-Identifier: GPL-3.0-or-later
// Every command that makes something says what it made as one JSON object.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "random_store.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

/// What a command that succeeds prints; null where that is no JSON object.
Json object_of(const std::string& command) {
  const Outcome outcome = run("-q --json " + command);
  EXPECT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.err;
  const Json json = Json::parse(outcome.out, nullptr, false);
  EXPECT_TRUE(json.is_object()) << command << " printed: " << outcome.out;
  return json.is_object() ? json : Json();
}

TEST(JsonOutput, IsOneObjectOfEachCommand) {
  const Folder folder;
  const auto in = [&](const char* name) { return (folder / name).string(); };
  const Json simulated =
      object_of("simulate " + kTwoRooms + " --tour --sensor laser -o " + in("m"));
  EXPECT_EQ(simulated.at("files")[0], "mission.clf");
  EXPECT_EQ(object_of("simulate --random-rooms 2 -o " + in("r")).at("files")[0], "building.gpkg");
  const std::string log = in("m") + "/mission.clf";
  EXPECT_EQ(object_of("map " + log + " -o " + in("b.gpkg")).at("store"), in("b.gpkg"));
  const Json assembled = object_of("assemble " + in("b.gpkg"));
  EXPECT_EQ(assembled.at("rooms").size(), 2U);
  EXPECT_EQ(assembled.at("files").size(), 0U);
  const Json renamed = object_of("rename " + in("b.gpkg") + " 1 Kitchen");
  EXPECT_EQ(renamed,
            (Json{{"store", in("b.gpkg")}, {"room", 1}, {"was", "1"}, {"name", "Kitchen"}}));
  EXPECT_EQ(object_of("report " + in("b.gpkg") + " -o " + in("r.html")).at("files")[0], "r.html");
  object_of("convert " + log + " -o " + in("m.mcap"));
  object_of("evaluate " + in("b.gpkg"));

  ASSERT_EQ(
      run("-q simulate " + kTwoRooms + " --tour --sensor laser --seed 3 -o " + in("n")).exit_code,
      0);
  ASSERT_EQ(run("-q map " + in("n") + "/mission.clf -o " + in("c.gpkg")).exit_code, 0);
  ASSERT_EQ(run("-q assemble " + in("c.gpkg")).exit_code, 0);
  const Json joined =
      object_of("join " + in("b.gpkg") + " " + in("c.gpkg") + " -o " + in("j.gpkg"));
  ASSERT_EQ(joined.at("buildings").size(), 1U);
  EXPECT_EQ(joined["buildings"][0]["missions"].size(), 2U);
  EXPECT_EQ(joined["buildings"][0]["rooms"], 2);
  EXPECT_EQ(joined.at("alone").size(), 0U);
}

TEST(OptionsThatSayNothing, AreRefused) {
  const Folder folder;
  const std::string out = (folder / "out").string();
  const Outcome picture = run("simulate " + kTwoRooms + " --resolution 0.1 -o " + out);
  EXPECT_EQ(picture.exit_code, 2);
  EXPECT_THAT(picture.err, HasSubstr("a resolution is given for pictures"));
  const std::string store = assembled_store(folder);
  EXPECT_EQ(run("locate " + store + " " + kTwoRooms + " --from nan").exit_code, 2);
  const Outcome config = run("--json config --print");
  EXPECT_EQ(config.exit_code, 2);
  EXPECT_THAT(config.err, HasSubstr("TOML"));
}

}  // namespace
}  // namespace roomatlas::test
