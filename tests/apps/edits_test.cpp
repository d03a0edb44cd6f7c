// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections by hand, as a user makes them: kept, replayed, and said where they no longer fit.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "random_store.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

std::string edits_file(const Folder& folder, const std::string& statements) {
  return folder
      .write("edits.json",
             R"({"format":"roomatlas-edits","version":1,"edits":[)" + statements + "]}")
      .string();
}

/// A laser's drive through two rooms, mapped and assembled once for all tests here.
class Edits : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = new Folder;
    const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/two_rooms.geojson";
    const std::string mission = (*shared_ / "m").string();
    ASSERT_EQ(run("-q simulate " + world + " --sensor laser --max-time 90 -o " + mission).exit_code,
              0);
    ASSERT_EQ(run("-q map " + log() + " -o " + (*shared_ / "b.gpkg").string()).exit_code, 0);
    ASSERT_EQ(run("-q assemble " + (*shared_ / "b.gpkg").string()).exit_code, 0);
  }
  static void TearDownTestSuite() { delete shared_; }
  void SetUp() override { std::filesystem::copy_file(*shared_ / "b.gpkg", store()); }

  static std::string log() { return (*shared_ / "m/mission.clf").string(); }
  [[nodiscard]] std::string store() const { return (folder_ / "building.gpkg").string(); }
  [[nodiscard]] std::string plan() const {
    const std::string out = (folder_ / "plan").string();
    EXPECT_EQ(run("-q export " + store() + " -f geojson -o " + out).exit_code, 0);
    return content_of(out + "/plan.local.geojson");
  }
  static inline Folder* shared_ = nullptr;
  Folder folder_;
};

TEST_F(Edits, AreReplayedAfterMappingAgainToTheSameBytes) {
  const std::string plain = plan();
  const std::string edits = edits_file(folder_, R"(
    {"edit":"name_room","room":{"id":1},"name":"Kitchen"},
    {"edit":"set_room_kind","room":{"id":1},"kind":"hall"},
    {"edit":"split_room","room":{"id":2},"line_m":[[5.5,-2.2],[5.5,3.5]]},
    {"edit":"move_wall","wall_m":[[2.4,-2.0],[2.4,2.0]],"by_m":-0.1},
    {"edit":"shut_door","at_m":[2.4,-0.15]},
    {"edit":"add_door","jambs_m":[[2.5,0.8],[2.5,1.6]]})");
  const Outcome assembled = run("assemble " + store() + " --edits " + edits);
  ASSERT_EQ(assembled.exit_code, 0) << assembled.err;
  EXPECT_THAT(assembled.err, Not(HasSubstr("no longer fits")));
  const std::string edited = plan();
  EXPECT_NE(edited, plain);
  EXPECT_THAT(edited, HasSubstr("Kitchen"));
  ASSERT_EQ(run("-q assemble " + store()).exit_code, 0) << "kept in the store";
  EXPECT_EQ(plan(), edited);
  ASSERT_EQ(run("-q map " + log() + " -o " + store()).exit_code, 0);
  ASSERT_EQ(run("-q assemble " + store()).exit_code, 0);
  EXPECT_EQ(plan(), edited);
}

TEST_F(Edits, ThatNoLongerFitAreSaidAndNotApplied) {
  const std::string plain = plan();
  const std::string edits = edits_file(folder_, R"({"edit":"shut_door","at_m":[900.0,0.0]})");
  const Outcome assembled = run("assemble " + store() + " --edits " + edits);
  EXPECT_EQ(assembled.exit_code, 0);
  EXPECT_THAT(assembled.err, HasSubstr("edits[0] shut_door: no longer fits and is not applied: no "
                                       "door or opening is near (900.00, 0.00)"));
  EXPECT_EQ(plan(), plain);
}

TEST_F(Edits, ThatCannotBeReadLeaveTheStoreAsItWas) {
  const std::string bytes = content_of(store());
  const std::string edits = edits_file(folder_, R"({"edit":"shut_door"})");
  const Outcome refused = run("assemble " + store() + " --edits " + edits);
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("edits.json: edits[0].at_m: missing"));
  EXPECT_TRUE(content_of(store()) == bytes) << "the store was changed";
}

TEST_F(Edits, FromAClickOnThePageToThePlan) {
  ROOMATLAS_NEEDS("chromium");
  ROOMATLAS_NEEDS("node");
  const std::string page = (folder_ / "report.html").string();
  ASSERT_EQ(run("-q report " + store() + " -o " + page).exit_code, 0);
  for (const char* size : {"1440 1000", "390 844"}) {
    const Outcome clicked = run_other("timeout 300 node " + std::string(ROOMATLAS_SOURCE_DIR) +
                                      "/tests/apps/browser/click_edits.mjs " + page + " " +
                                      (folder_ / "profile").string() + " " + size);
    ASSERT_EQ(clicked.exit_code, 0) << clicked.err;
    const Json saved = Json::parse(clicked.out);
    std::string kinds;
    for (const Json& one : saved["edits"]) kinds += one["edit"].get<std::string>() + " ";
    EXPECT_EQ(kinds, "name_room set_room_kind shut_door split_room ") << size;
    const auto edits = folder_.write("saved.json", clicked.out);
    const std::string copy = (folder_ / "copy.gpkg").string();
    std::filesystem::copy_file(store(), copy, std::filesystem::copy_options::overwrite_existing);
    const Outcome assembled = run("assemble " + copy + " --edits " + edits.string());
    EXPECT_EQ(assembled.exit_code, 0) << assembled.err;
    EXPECT_THAT(assembled.err, Not(HasSubstr("no longer fits")));
    EXPECT_THAT(assembled.err, HasSubstr("3 rooms, 1 door\n"));
  }
}

TEST_F(Edits, RenameWritesTheSameStatement) {
  ASSERT_EQ(run("-q rename " + store() + " 1 Kitchen").exit_code, 0);
  const std::string renamed = plan();
  ASSERT_EQ(run("-q assemble " + store()).exit_code, 0);
  EXPECT_EQ(plan(), renamed);
  const std::string other = (folder_ / "other.gpkg").string();
  std::filesystem::copy_file(*shared_ / "b.gpkg", other);
  const std::string edits =
      edits_file(folder_, R"({"edit":"name_room","room":{"id":1},"name":"Kitchen"})");
  ASSERT_EQ(run("-q assemble " + other + " --edits " + edits).exit_code, 0);
  std::filesystem::rename(other, store());
  EXPECT_EQ(plan(), renamed);
}

}  // namespace
}  // namespace roomatlas::test
