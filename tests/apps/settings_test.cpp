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

TEST(Settings, BelieveOdometrysDirectionsIfAsked) {
  const apps::Settings settings = parsed("--no-find-reverse");
  EXPECT_FALSE(settings.map.directions.find_reverse);
  EXPECT_TRUE(parsed("").map.directions.find_reverse);
}

TEST(Settings, TakeAnglesInDegreesAndKeepThemInRadians) {
  const MotionSigma given = parsed("--odometry-heading 2").assemble.correct.odometry.heading;
  EXPECT_EQ(given.still, radians(2.0));
  EXPECT_EQ(given.per_m, CorrectOptions().odometry.heading.per_m);
  const std::string toml = parsed("").as_toml;
  EXPECT_NE(toml.find("\nodometry-heading=1\n"), std::string::npos) << toml;
  EXPECT_NE(toml.find("\nodometry-heading-rate=0.6\n"), std::string::npos);
}

TEST(Settings, KnowWhatWasGiven) {
  const std::set<std::string> expected = {"cell", "draw-path"};
  EXPECT_EQ(parsed("--cell 0.1 --draw-path").given, expected);
}

}  // namespace
}  // namespace roomatlas::test
