// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "random_store.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

class Rename : public ::testing::Test {
 protected:
  void SetUp() override { store_ = assembled_store(folder_); }
  [[nodiscard]] std::string csv() {
    const std::string out = (folder_ / "csv").string();
    EXPECT_EQ(run("-q export " + store_ + " -f csv -o " + out).exit_code, 0);
    return content_of(out + "/rooms.csv");
  }
  Folder folder_;
  std::string store_;
};

TEST_F(Rename, TakesANumberOrTheNameThatARoomHas) {
  ASSERT_EQ(run("-q rename " + store_ + " 3 'Lab 315'").exit_code, 0);
  EXPECT_THAT(csv(), HasSubstr("\n3,Lab 315,"));
  ASSERT_EQ(run("-q rename " + store_ + " 'Lab 315' Kitchen").exit_code, 0);
  EXPECT_THAT(csv(), HasSubstr("\n3,Kitchen,"));
}

TEST_F(Rename, AnUnknownRoomOrAnEmptyNameIsAUsageError) {
  const Outcome unknown = run("-q rename " + store_ + " 999 Attic");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("its rooms are 1, 2"));
  EXPECT_EQ(run("-q rename " + store_ + " 3 ' '").exit_code, 2);
  EXPECT_EQ(run("-q rename " + store_ + " 3 'caf\xE9'").exit_code, 2);
}

TEST_F(Rename, ToANameThatAnotherRoomShowsIsRefused) {
  const Outcome taken = run("-q rename " + store_ + " 1 2");
  EXPECT_EQ(taken.exit_code, 2);
  EXPECT_THAT(taken.err, HasSubstr("room 2 is called \"2\" already"));
  ASSERT_EQ(run("-q rename " + store_ + " 2 Lab").exit_code, 0);
  EXPECT_EQ(run("-q rename " + store_ + " 3 Lab").exit_code, 2);
  EXPECT_EQ(run("-q rename " + store_ + " 2 Lab").exit_code, 0);
  const Outcome number = run("-q rename " + store_ + " 1 2");  // which no edit may say, either
  EXPECT_EQ(number.exit_code, 2);
  EXPECT_THAT(number.err, HasSubstr("2 is the number of the room \"Lab\""));
}

TEST_F(Rename, IsKeptWhenTheStoreIsAssembledAgain) {
  const std::string before = csv();
  ASSERT_EQ(run("-q rename " + store_ + " 3 'Lab 315'").exit_code, 0);
  ASSERT_EQ(run("-q assemble " + store_).exit_code, 0);
  std::string expected = before;
  expected.replace(expected.find("\n3,3,"), 5, "\n3,Lab 315,");
  EXPECT_EQ(csv(), expected);
}

TEST_F(Rename, ToTheOldNameLeavesTheSameBytes) {
  const std::string bytes = content_of(store_);
  ASSERT_EQ(run("-q rename " + store_ + " 3 'Lab 315'").exit_code, 0);
  EXPECT_NE(content_of(store_), bytes);
  ASSERT_EQ(run("-q rename " + store_ + " 3 3").exit_code, 0);
  EXPECT_EQ(content_of(store_), bytes);
}

TEST(RenameAcrossMaps, NamesSurviveMappingTheSameLogAgainAndAreMissedByName) {
  const Folder folder;
  const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/two_rooms.geojson";
  const std::string mission = (folder / "m").string();
  ASSERT_EQ(run("-q simulate " + world + " --sensor laser --max-time 60 -o " + mission).exit_code,
            0);
  const std::string log = mission + "/mission.clf";
  const std::string store = (folder / "building.gpkg").string();
  ASSERT_EQ(run("-q map " + log + " -o " + store).exit_code, 0);
  ASSERT_EQ(run("-q assemble " + store).exit_code, 0);
  ASSERT_EQ(run("-q rename " + store + " 1 'Lab 315'").exit_code, 0);
  ASSERT_EQ(run("-q map " + log + " -o " + store).exit_code, 0);
  ASSERT_EQ(run("-q assemble " + store).exit_code, 0);
  ASSERT_EQ(run("-q export " + store + " -f csv -o " + mission).exit_code, 0);
  EXPECT_THAT(content_of(mission + "/rooms.csv"), HasSubstr("\n1,Lab 315,"));

  const std::string other = (folder / "other").string();
  ASSERT_EQ(
      run("-q simulate " + world + " --sensor laser --max-time 60 --seed 7 -o " + other).exit_code,
      0);
  const Outcome mapped = run("map " + other + "/mission.clf -o " + store);
  EXPECT_EQ(mapped.exit_code, 0);
  EXPECT_THAT(mapped.err, HasSubstr("Lab 315"));
}

}  // namespace
}  // namespace roomatlas::test
