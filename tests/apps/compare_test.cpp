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
    return run("compare " + before + " " + after + " " + flags + " -o " +
               (*folder_ / "out").string());
  }

  /// Place and size of the changes that no cell more or less decides. Both missions began at one
  /// place, so that their frames are one but for a tenth of a degree.
  static std::vector<std::tuple<double, double, double>> large(const Json& json) {
    std::vector<std::tuple<double, double, double>> found;
    for (const Json& change : json["changes"]) {
      const double size_m = change["size_m"];
      if (size_m > 0.6) found.emplace_back(change["at"][0], change["at"][1], size_m);
    }
    return found;
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
  const auto told = large(json);
  const auto told_in_reverse = large(Json::parse(reverse.out));
  EXPECT_GE(told.size(), 8U);
  ASSERT_EQ(told.size(), told_in_reverse.size());  // what is new one way is gone the other
  for (const auto& [x_m, y_m, size_m] : told) {
    EXPECT_TRUE(std::any_of(told_in_reverse.begin(), told_in_reverse.end(),
                            [&](const auto& other) {
                              return std::hypot(std::get<0>(other) - x_m,
                                                std::get<1>(other) - y_m) < 0.1 &&
                                     std::abs(std::get<2>(other) - size_m) < 0.1;
                            }))
        << x_m << " " << y_m << " " << size_m;
  }
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
