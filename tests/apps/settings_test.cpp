// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind_parameters.hpp"

#include <gtest/gtest.h>

namespace roomatlas::test {
namespace {

apps::Settings parsed(const std::string& arguments) {
  CLI::App app;
  apps::Settings settings;
  apps::bind_parameters(app, settings);
  app.parse(arguments);
  apps::complete(settings, app);
  return settings;
}

TEST(Settings, NoFindReverseHoldsForSonarsToo) {
  const apps::Settings settings = parsed("--no-find-reverse");
  EXPECT_FALSE(settings.map.reckon.find_reverse);
  EXPECT_FALSE(settings.assemble.sonars.directions.find_reverse);
  EXPECT_TRUE(parsed("").assemble.sonars.directions.find_reverse);
}

TEST(Settings, KnowWhatWasGiven) {
  const std::set<std::string> expected = {"cell", "draw-path"};
  EXPECT_EQ(parsed("--cell 0.1 --draw-path").given, expected);
}

}  // namespace
}  // namespace roomatlas::test
