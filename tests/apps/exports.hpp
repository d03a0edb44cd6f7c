// SPDX-License-Identifier: GPL-3.0-or-later
// A store whose files other programs are to read.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "random_store.hpp"

namespace roomatlas::test {

using Json = nlohmann::json;

class Exports : public ::testing::Test {
 protected:
  void SetUp() override {
    store_ = assembled_store(folder_);
    ASSERT_EQ(run("-q rename " + store_ + " 3 'Lab <3> & Kitchen'").exit_code, 0);
  }
  /// @returns the folder, with a slash
  std::string exported(const std::string& options) {
    const std::string out = (folder_ / "out").string();
    const Outcome outcome = run("-q export " + store_ + " " + options + " -o " + out);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return out + "/";
  }
  [[nodiscard]] Json rooms(const std::string& out) const {
    Json found = Json::array();
    const Json plan = Json::parse(content_of(out + "plan.local.geojson"));
    for (const Json& feature : plan["features"]) {
      if (feature["properties"].contains("area_m2")) found.push_back(feature["properties"]);
    }
    return found;
  }

  Folder folder_;
  std::string store_;
};

}  // namespace roomatlas::test
