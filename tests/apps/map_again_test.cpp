// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a store when a mission is mapped into its place.
#include <gmock/gmock.h>

#include <algorithm>

#include "child.hpp"

namespace roomatlas::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// The demo mission, simulated once for all tests of this file; a second and more to map.
std::string mission() {
  static const Folder folder;
  static const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/eight_rooms";
  static const Outcome simulated = run("-q simulate " + world + ".geojson --drive " + world +
                                       ".drive -o " + (folder / "m").string());
  EXPECT_EQ(simulated.exit_code, 0) << simulated.err;
  return (folder / "m" / "mission.clf").string();
}

class MapAgain : public ::testing::Test {
 protected:
  [[nodiscard]] std::string map_it(const std::string& options = "") const {
    return options + " map " + mission() + " -o " + store_;
  }
  /// The store that is to be replaced, mapped once for all tests.
  static const std::string& before() {
    static const std::string bytes = [] {
      const Folder folder;
      const std::string store = (folder / "building.gpkg").string();
      EXPECT_EQ(run("-q --cell 0.15 map " + mission() + " -o " + store).exit_code, 0);
      return content_of(store);
    }();
    return bytes;
  }
  void SetUp() override {
    ASSERT_NE(before(), "");
    (void)folder_.write("building.gpkg", before());
  }
  [[nodiscard]] bool is_as_before() const { return content_of(store_) == before(); }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / "")) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  /// A log that cannot be mapped, which is found out at its end.
  [[nodiscard]] fs::path no_wall_seen() const {
    std::string log;
    for (int i = 0; i < 50; ++i) {
      const std::string stamp = std::to_string(i);
      log += "ODOM 0." + stamp + " 0 0 0 0 0 " + stamp + " host " + stamp + "\n";
      log += "SONAR 0.5 1 5.0 0 0 0 " + stamp + " host " + stamp + "\n";
    }
    return folder_.write("no_wall.clf", log);
  }

  Folder folder_;
  std::string store_ = (folder_ / "building.gpkg").string();
  std::string new_store_ = store_ + ".new";
};

TEST_F(MapAgain, ReplacesTheStoreAndLeavesNothingBeside) {
  ASSERT_EQ(run(map_it("-q")).exit_code, 0);
  EXPECT_FALSE(is_as_before());
  EXPECT_THAT(names(), ::testing::ElementsAre("building.gpkg"));
}

TEST_F(MapAgain, KilledTwiceLeavesTheFinishedMapAsItWas) {
  for (int i = 0; i < 2; ++i) {
    Child child(map_it());
    ASSERT_TRUE(child.has_said("map ...")) << child.err();
    child.send({SIGKILL});
    EXPECT_EQ(child.wait(), SIGKILL);
    EXPECT_TRUE(is_as_before());
  }
  ASSERT_EQ(run(map_it("-q")).exit_code, 0);
  EXPECT_FALSE(is_as_before());
  EXPECT_THAT(names(), ::testing::ElementsAre("building.gpkg"));
}

TEST_F(MapAgain, WithoutSpaceOnTheDiskLeavesTheFinishedMapAsItWas) {
  const std::string small_files = "trap '' XFSZ; ulimit -f 200; ";
  Child child(map_it("-q"), small_files);
  EXPECT_EQ(child.wait(), 0);
  EXPECT_EQ(child.exit_code(), 3) << child.err();
  EXPECT_TRUE(is_as_before());
  EXPECT_THAT(names(), ::testing::ElementsAre("building.gpkg"));
}

TEST_F(MapAgain, InterruptedLeavesTheFinishedMapAndTheRoomsSoFarBesideIt) {
  Child child(map_it());
  ASSERT_TRUE(child.has_said("map ...")) << child.err();
  child.send({SIGINT});
  EXPECT_EQ(child.wait(), 0);
  EXPECT_EQ(child.exit_code(), 130);
  EXPECT_THAT(child.err(), HasSubstr("the rooms so far are in " + new_store_ + ", and " + store_ +
                                     " is as it was; run the same command to go on"));
  EXPECT_TRUE(is_as_before());
  EXPECT_EQ(run("-q assemble " + new_store_).exit_code, 0);
}

TEST_F(MapAgain, InterruptedTwiceWithoutAFinishedMapHasTheRoomsSoFarInItsPlace) {
  fs::remove(store_);
  for (int i = 0; i < 2; ++i) {
    Child child(map_it());
    ASSERT_TRUE(child.has_said("map ...")) << child.err();
    child.send({SIGINT});
    EXPECT_EQ(child.wait(), 0);
    EXPECT_THAT(child.err(), HasSubstr("the rooms so far are in " + store_ + "; run"));
    EXPECT_THAT(names(), ::testing::ElementsAre("building.gpkg"));
  }
  EXPECT_EQ(run("-q assemble " + store_).exit_code, 0);
}

TEST_F(MapAgain, AFinishedMapThatAKilledRunLeftBesideTakesItsPlace) {
  const std::string finished = (folder_ / "other.gpkg").string();
  ASSERT_EQ(run("-q map " + mission() + " -o " + finished).exit_code, 0);
  const std::string bytes = content_of(finished);
  fs::rename(finished, new_store_);
  std::ofstream(store_ + "-journal") << "of the store that was replaced";
  const Outcome refused = run("map " + no_wall_seen().string() + " -o " + store_);
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_THAT(refused.err, HasSubstr("this is done now"));
  EXPECT_EQ(content_of(store_), bytes);
  EXPECT_THAT(names(), ::testing::ElementsAre("building.gpkg", "no_wall.clf"));
}

TEST_F(MapAgain, IntoAFolderIsRefused) {
  const Outcome outcome = run("-q map " + mission() + " -o " + (folder_ / "").string());
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("is a directory"));
  EXPECT_TRUE(is_as_before());
}

}  // namespace
}  // namespace roomatlas::test
