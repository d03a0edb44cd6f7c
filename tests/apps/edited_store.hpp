// SPDX-License-Identifier: GPL-3.0-or-later
// A store of two rooms that statements are tried on.
#pragma once

#include <gtest/gtest.h>

#include "random_store.hpp"

namespace roomatlas::test {

inline std::string edits_file(const Folder& folder, const std::string& statements) {
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

}  // namespace roomatlas::test
