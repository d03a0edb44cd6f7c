// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "child.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A simulation that lasts and asks at each room.
std::string long_simulation(const Folder& folder) {
  return "simulate --random-rooms 1000000 -o " + (folder / "out").string();
}

TEST(Interrupt, EndsACommandThatAsksWithExitCode130) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Folder folder;
    Child child(long_simulation(folder));
    ASSERT_TRUE(child.has_said("simulate ...")) << child.err();
    child.send({signal});
    EXPECT_EQ(child.wait(), 0);
    EXPECT_EQ(child.exit_code(), 130);
    EXPECT_THAT(child.err(), HasSubstr("interrupted while simulating"));
  }
}

TEST(Interrupt, ASecondSignalEndsItAtOnce) {
  const Folder folder;
  Child child(long_simulation(folder));
  ASSERT_TRUE(child.has_said("simulate ...")) << child.err();
  child.send({SIGINT, SIGTERM});
  EXPECT_EQ(child.wait(), SIGTERM);
}

TEST(Interrupt, EndsACommandThatNeverAsksAtOnce) {
  const Folder folder;
  const std::string graph = (folder / "in.g2o").string();
  ASSERT_EQ(mkfifo(graph.c_str(), 0600), 0);
  Child child("optimize " + graph + " -o " + (folder / "out.g2o").string());
  const int writer = open(graph.c_str(), O_WRONLY | O_CLOEXEC);  // returns once it is read from
  child.send({SIGINT});
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  close(writer);  // a program that goes on finds an empty file
  EXPECT_EQ(child.wait(), SIGINT);
}

TEST(Interrupt, OfASimulationWithoutItsMissionDoesNotSayThatAnythingIsKept) {
  const Folder folder;
  const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/eight_rooms.geojson";
  Child child("simulate " + world + " --sensor laser -o " + (folder / "out").string());
  ASSERT_TRUE(child.has_said("simulating ...")) << child.err();
  child.send({SIGINT});
  EXPECT_EQ(child.wait(), 0);
  EXPECT_EQ(child.exit_code(), 130);
  EXPECT_THAT(child.err(), HasSubstr("no mission was written\n"));
  EXPECT_THAT(child.err(), Not(HasSubstr("mapped")));
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "mission.clf"));
}

}  // namespace
}  // namespace roomatlas::test
