// SPDX-License-Identifier: GPL-3.0-or-later
// `compare` as a user runs it: two missions of simulated rooms, empty and furnished.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "random_store.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class Compare : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    empty_ = built("empty", "--seed 1");
    again_ = built("again", "--seed 2");
    furnished_ = built("furnished", "--seed 3 --furnish 1");
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static std::string built(const std::string& name, const std::string& flags) {
    const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/two_rooms.geojson";
    const std::string place = (*folder_ / name).string();
    const Outcome made =
        run("-q simulate " + world + " --sensor laser --tour " + flags + " -o " + place);
    EXPECT_EQ(made.exit_code, 0) << made.err;
    const std::string store = place + "/building.gpkg";
    EXPECT_EQ(run("-q map " + place + "/mission.clf -o " + store).exit_code, 0);
    EXPECT_EQ(run("-q assemble " + store).exit_code, 0);
    return store;
  }

  static Outcome compared(const std::string& before, const std::string& after,
                          const std::string& flags = "") {
    return run("-q compare " + before + " " + after + " " + flags + " -o " +
               (*folder_ / "out").string());
  }

  static inline Folder* folder_ = nullptr;
  static inline std::string empty_;
  static inline std::string again_;
  static inline std::string furnished_;
};

TEST_F(Compare, SaysThatNothingChangedWhereNothingDid) {
  const Outcome done = compared(empty_, again_);
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("nothing changed"));
  EXPECT_THAT(content_of(*folder_ / "out/changes.csv"), StartsWith("id,kind,room,"));
  EXPECT_GT(content_of(*folder_ / "out/changes.png").size(), 1000U);
}

TEST_F(Compare, TellsFurnitureAndWhoSawIt) {
  const Outcome done = compared(empty_, furnished_, "--json");
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const Json json = Json::parse(done.out);
  ASSERT_GE(json["changes"].size(), 2U);
  for (const Json& change : json["changes"]) {
    EXPECT_THAT(change["kind"].get<std::string>(), testing::Not(HasSubstr("gone")));
    EXPECT_GE(change["before"]["passed_readings"], 5);
    EXPECT_GE(change["after"]["stood_readings"], 5);
    EXPECT_FALSE(change["after"]["visits"].empty());
  }
  const Json layer = Json::parse(content_of(*folder_ / "out/changes.geojson"));
  EXPECT_GE(layer["features"].size(), json["changes"].size());
  const Outcome reverse = compared(furnished_, empty_, "--json");
  // What is new one way is gone the other; groups at the rim of what was seen may fall apart.
  EXPECT_NEAR(static_cast<double>(Json::parse(reverse.out)["changes"].size()),
              static_cast<double>(json["changes"].size()), 2.0);
}

TEST_F(Compare, GivesTheSameBytesWithAnyNumberOfThreads) {
  ASSERT_EQ(compared(empty_, furnished_, "--jobs 1").exit_code, 0);
  const std::string svg = content_of(*folder_ / "out/changes.svg");
  const std::string csv = content_of(*folder_ / "out/changes.csv");
  ASSERT_EQ(compared(empty_, furnished_, "--jobs 3").exit_code, 0);
  EXPECT_EQ(content_of(*folder_ / "out/changes.svg"), svg);
  EXPECT_EQ(content_of(*folder_ / "out/changes.csv"), csv);
}

TEST_F(Compare, RefusesBuildingsThatHaveNothingInCommonThere) {
  const Outcome done = compared(empty_, again_, "--old-from-new 100,0,0");
  EXPECT_EQ(done.exit_code, 4);
  EXPECT_THAT(done.err, HasSubstr("nothing in common within 1 m and 5 deg"));
}

TEST_F(Compare, RefusesStoresThatHoldTooLittle) {
  const std::string place = (*folder_ / "random").string();
  ASSERT_EQ(run("-q simulate --random-rooms 3 -o " + place).exit_code, 0);
  const std::string store = place + "/building.gpkg";
  const Outcome bare = compared(empty_, store);
  EXPECT_EQ(bare.exit_code, 4);
  EXPECT_THAT(bare.err, HasSubstr("random/building.gpkg: not assembled yet"));
  ASSERT_EQ(run("-q assemble " + store).exit_code, 0);
  const Outcome without_readings = compared(store, empty_);
  EXPECT_EQ(without_readings.exit_code, 4);
  EXPECT_THAT(without_readings.err, HasSubstr("without its readings"));
  EXPECT_EQ(compared(empty_, "missing.gpkg").exit_code, 3);
  EXPECT_EQ(compared(empty_, again_, "--old-from-new 1,2").exit_code, 2);
}

}  // namespace
}  // namespace roomatlas::test
