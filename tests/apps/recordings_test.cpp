// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says and returns for recordings that cannot be mapped as they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "program.hpp"

namespace roomatlas::test {
namespace {

/// A mission through both rooms as a recording.
std::string recording(const Folder& folder, const std::string& format,
                      const std::string& sensor = "laser") {
  const Outcome outcome = run("-q simulate " + kTwoRooms + " --sensor " + sensor + " --format " +
                              format + " -o " + (folder / "log").string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return (folder / "log" / ("mission." + format)).string();
}

/// Both commands must return the code; one line on stderr says why.
void expect_refused(const Folder& folder, const std::string& recording, const std::string& flags,
                    int exit_code, const std::string& mentions) {
  const Outcome told = run("-q info " + recording + " " + flags);
  EXPECT_EQ(told.exit_code, exit_code) << told.err;
  EXPECT_NE(told.err.find(mentions), std::string::npos) << told.err;
  const Outcome built =
      run("-q build " + recording + " " + flags + " -o " + (folder / "out").string());
  EXPECT_EQ(built.exit_code, exit_code) << built.err;
  EXPECT_NE(built.err.find(mentions), std::string::npos) << built.err;
  EXPECT_EQ(std::count(built.err.begin(), built.err.end(), '\n'), 1) << built.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "building.gpkg"));
}

TEST(Recordings, CutInTheMiddleAreMappedAsFarAsTheyGo) {
  for (const std::string format : {"bag", "mcap"}) {
    const Folder folder;
    const std::string whole = content_of(recording(folder, format, "sonar"));
    const std::string cut =
        folder.write("cut." + format, whole.substr(0, whole.size() * 7 / 10)).string();
    const Outcome told = run("--json info " + cut);
    ASSERT_EQ(told.exit_code, 0) << told.err;
    EXPECT_GT(nlohmann::json::parse(told.out)["readings"].get<int>(), 50) << format;
    EXPECT_NE(run("info " + cut).err.find("warning"), std::string::npos);  // what was lost is said
    EXPECT_EQ(run("-q build " + cut + " -o " + (folder / "out").string()).exit_code, 0) << format;
  }
}

TEST(Recordings, CutAtTheirBeginningAreRefused) {
  for (const std::string format : {"bag", "mcap", "db3"}) {
    const Folder folder;
    const std::string whole = content_of(recording(folder, format));
    const std::string cut = folder.write("cut." + format, whole.substr(0, 40)).string();
    expect_refused(folder, cut, "", 3, "cut." + format);
  }
}

TEST(Recordings, OptionsThatNameNothingThereAreWrongUse) {
  const Folder folder;
  const std::string mcap = recording(folder, "mcap");
  expect_refused(folder, mcap, "--scan-topic /front", 2,
                 "no such topic; nearest comes /odom; there are");
  expect_refused(folder, mcap, "--odom-topic /wheels", 2, "--odom-topic /wheels");
  expect_refused(folder, mcap, "--scan-topic /odom", 2, "expected sensor_msgs/LaserScan");
  expect_refused(folder, mcap, "--truth-topic /scan", 2, "expected nav_msgs/Odometry");
}

TEST(Recordings, TruthOfATopicIsWhatThePlanIsJudgedBy) {
  const Folder folder;
  const std::string mcap = recording(folder, "mcap");
  const auto figures_with = [&](const std::string& flags, const std::string& out) {
    const Outcome built =
        run("-q --json build " + mcap + " " + flags + " -o " + (folder / out).string());
    EXPECT_EQ(built.exit_code, 0) << built.err;
    return nlohmann::json::parse(built.out);
  };
  const auto judged = figures_with("", "a");
  EXPECT_EQ(figures_with("--truth-topic /ground_truth", "b"), judged);
  EXPECT_LT(judged["true_poses"]["after"]["position_m"]["rmse"].get<double>(), 0.01);
  EXPECT_FALSE(figures_with("--truth-topic none", "c").contains("true_poses"));
}

}  // namespace
}  // namespace roomatlas::test
