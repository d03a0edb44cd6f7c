// SPDX-License-Identifier: GPL-3.0-or-later
// The same mission with one thread and with several.
#include <gmock/gmock.h>

#include <map>

#include "program.hpp"

namespace roomatlas::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// The demo's drive.
std::string simulated(const Folder& folder, const std::string& sensor) {
  const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/eight_rooms";
  const std::string out = (folder / sensor).string();
  const Outcome outcome = run("-q simulate " + world + ".geojson --drive " + world +
                              ".drive --sensor " + sensor + " -o " + out);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return out + "/mission.clf";
}

std::map<std::string, std::string> built(const std::string& log, int jobs) {
  const Folder folder;
  const fs::path out = folder / "out";
  const Outcome outcome =
      run("-q build " + log + " -o " + out.string() + " --jobs " + std::to_string(jobs));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return files_in(out);
}

void expect_same_bytes(const std::string& sensor) {
  const Folder folder;
  const std::string log = simulated(folder, sensor);
  const auto by_one = built(log, 1);
  EXPECT_TRUE(by_one.contains("building.gpkg"));
  for (const int jobs : {2, 5}) {
    const auto by_several = built(log, jobs);
    EXPECT_EQ(by_several.size(), by_one.size());
    for (const auto& [name, content] : by_one) {
      EXPECT_TRUE(by_several.contains(name) && by_several.at(name) == content)
          << name << " with " << jobs << " jobs";
    }
  }
}

TEST(Jobs, GiveTheSameBytesHoweverManyOfASonarMission) { expect_same_bytes("sonar"); }

TEST(Jobs, GiveTheSameBytesHoweverManyOfALaserMission) { expect_same_bytes("laser"); }

TEST(Jobs, DoNotMakeBuildMapAgain) {
  const Folder folder;
  const std::string m = (folder / "m").string();
  ASSERT_EQ(run("-q simulate " + kTwoRooms + " --tour -o " + m).exit_code, 0);
  const std::string build = "build " + m + "/mission.clf -o " + (folder / "out").string();
  EXPECT_THAT(run(build + " --jobs 1").err, Not(HasSubstr("holds this mission already")));
  EXPECT_THAT(run(build + " --jobs 2").err, HasSubstr("holds this mission already"));
}

TEST(Jobs, AreKeptInNoConfigurationAndReadFromNone) {
  EXPECT_THAT(run("--jobs 3 config --print").out, Not(HasSubstr("jobs")));
  const Folder folder;
  const std::string file = folder.write("my.toml", "jobs = 2\n").string();
  const Outcome outcome = run("--config " + file + " config --print");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("my.toml:1: "));
}

TEST(Jobs, AreNotNegative) {
  const Outcome outcome = run("--jobs -1 config --print");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--jobs: Value -1 not in range"));
}

}  // namespace
}  // namespace roomatlas::test
