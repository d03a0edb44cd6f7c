// SPDX-License-Identifier: GPL-3.0-or-later
// Two missions through two rooms that are joined.
#pragma once

#include <gtest/gtest.h>

#include "random_store.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

namespace roomatlas::test {

class Join : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    one_ = log("one", "two_rooms", "--sensor laser --tour --seed 1");
    two_ = log("two", "two_rooms", "--sensor laser --tour --seed 2 --odometry-bias 2");
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static std::string log(const std::string& name, const std::string& world,
                         const std::string& flags) {
    const std::string file =
        std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/" + world + ".geojson";
    const std::string place = (*folder_ / name).string();
    const Outcome made = run("-q simulate " + file + " " + flags + " -o " + place);
    EXPECT_EQ(made.exit_code, 0) << made.err;
    std::filesystem::rename(place + "/mission.clf", place + "/" + name + ".clf");
    return place + "/" + name + ".clf";
  }

  /// What `build` says, as JSON too, that makes `built` of the two missions once for all tests.
  static const Outcome& built() {
    static const Outcome done = run("--json build " + one_ + " " + two_ + " -o " + built_folder());
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return done;
  }
  static std::string built_folder() { return (*folder_ / "built").string(); }
  /// A copy of that building and of its missions, for a test to alter.
  static std::string copy_of_built(const std::string& name) {
    EXPECT_EQ(built().exit_code, 0);
    std::filesystem::copy(built_folder(), *folder_ / name,
                          std::filesystem::copy_options::recursive);
    return (*folder_ / name).string();
  }

  static inline Folder* folder_ = nullptr;
  static inline std::string one_;
  static inline std::string two_;
};

}  // namespace roomatlas::test
