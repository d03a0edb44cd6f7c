// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.hpp"

namespace roomatlas::test {
namespace {

const std::vector<std::string> kNames = {"to.mcap", "to.bag", "to.db3", "to"};

/// A short mission as a CARMEN log.
std::filesystem::path mission(const Folder& folder, const std::string& flags = "--sensor laser") {
  const auto drive = folder.write("drive", "1.5 2.0\n3.0 2.4\n2.0 3.4\n");
  const Outcome outcome = run("-q simulate " + kTwoRooms + " " + flags + " --drive " +
                              drive.string() + " -o " + (folder / "log").string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return folder / "log" / "mission.clf";
}

/// Its lines but ODOM's, whose speeds recordings tell and readers do not ask for.
std::string readings_of(const std::filesystem::path& log) {
  std::istringstream lines(content_of(log));
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("ODOM")) text += line + "\n";
  }
  return text;
}

TEST(Convert, ThereAndBackIsTheSameLog) {
  for (const std::string sensor : {"--sensor laser", "--sensor sonar"}) {
    const Folder folder;
    const auto log = mission(folder, sensor);
    for (const std::string& name : kNames) {
      const std::string there = (folder / name).string();
      const Outcome to = run("-q convert " + log.string() + " -o " + there);
      ASSERT_EQ(to.exit_code, 0) << to.err;
      const auto back = folder / "back.clf";
      const Outcome from = run("-q convert " + there + " -o " + back.string());
      ASSERT_EQ(from.exit_code, 0) << from.err;
      EXPECT_TRUE(readings_of(back) == readings_of(log)) << sensor << " " << name;
    }
  }
}

TEST(Convert, GoesOnWhereARunWasKilledThatMadeAFolder) {
  const Folder folder;
  const auto log = mission(folder);
  std::filesystem::create_directory(folder / "bag");
  folder.write("bag/bag_0.db3.part", "half of a recording");
  const Outcome done = run("-q convert " + log.string() + " -o " + (folder / "bag/").string());
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "bag/bag_0.db3.part"));
  EXPECT_TRUE(std::filesystem::exists(folder / "bag/metadata.yaml"));

  // Results do not go into the recording, which they would change; its name may end in a slash.
  const Outcome inside =
      run("-q build " + (folder / "bag/").string() + " -o " + (folder / "bag/out").string());
  EXPECT_EQ(inside.exit_code, 3);
  EXPECT_NE(inside.err.find("results do not go into the recording"), std::string::npos);
  const std::string out = (folder / "out/").string();
  (void)run("-q build " + (folder / "bag/").string() + " " + log.string() + " -o " + out);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/missions/bag.gpkg"));
}

TEST(Convert, RefusesWhatWouldBeLostAndNamesThatSayNoFormat) {
  const Folder folder;
  const auto log = mission(folder);
  const std::string bytes = content_of(log);
  EXPECT_EQ(run("-q convert " + log.string() + " -o " + log.string()).exit_code, 3);
  EXPECT_EQ(content_of(log), bytes);
  EXPECT_EQ(run("-q convert " + log.string() + " -o " + (folder / "a.txt").string()).exit_code, 3);
  // a folder with something in it is no place for a recording
  EXPECT_EQ(run("-q convert " + log.string() + " -o " + (folder / "log").string()).exit_code, 3);
  EXPECT_EQ(
      run("-q convert " + (folder / "none.bag").string() + " -o " + (folder / "a.mcap").string())
          .exit_code,
      3);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.mcap"));
}

TEST(Convert, WithoutOdometryItIsNoCarmenLog) {
  const Folder folder;
  const auto log = mission(folder);
  const std::string bag = (folder / "all.mcap").string();
  ASSERT_EQ(run("-q convert " + log.string() + " -o " + bag).exit_code, 0);
  const std::string scans = " --odom-topic none --laser-mount 0,0,0 -o ";
  const Outcome refused = run("-q convert " + bag + scans + (folder / "b.clf").string());
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_NE(refused.err.find("no odometry"), std::string::npos) << refused.err;
  const auto scan_only = folder / "scans.mcap";
  EXPECT_EQ(run("-q convert " + bag + scans + scan_only.string()).exit_code, 0);
  const Outcome told = run("-q --json info " + scan_only.string());
  ASSERT_EQ(told.exit_code, 0) << told.err;
  const auto json = nlohmann::json::parse(told.out);
  for (const auto& topic : json["recording"]["topics"]) {
    EXPECT_NE(topic["name"], "/odom");
    EXPECT_NE(topic["name"], "/tf");
  }
}

}  // namespace
}  // namespace roomatlas::test
