// SPDX-License-Identifier: GPL-3.0-or-later
// Commands without what they need of the machine: space on the disk, the right to write, memory.
// Each ends with its result or with an error that says what was missing, and goes on once it is
// there.
#include <gmock/gmock.h>

#include <array>

#include "random_store.hpp"

namespace roomatlas::test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Scarce : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/two_rooms.geojson";
    ASSERT_EQ(run("-q simulate " + world + " --max-time 30 --sensor laser -o " + path()).exit_code,
              0);
    ASSERT_EQ(run("-q build " + path("mission.clf") + " -o " + path("built")).exit_code, 0);
    std::filesystem::create_directories(path("small"));
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static std::string path(const std::string& name = "") { return (*folder_ / name).string(); }

  /// Commands that write into `small`.
  static std::vector<std::string> writers() {
    const std::string store = path("built/building.gpkg");
    return {"build " + path("mission.clf") + " -o " + path("small"),
            "map " + path("mission.clf") + " -o " + path("small/building.gpkg"),
            "export " + store + " -f svg,pdf,png,geojson,nav2,csv,ifc,imdf -o " + path("small"),
            "report " + store + " -o " + path("small/report.html"),
            "compare " + store + " " + store + " -o " + path("small"),
            "convert " + path("mission.clf") + " -o " + path("small/mission.mcap"),
            "convert " + path("mission.clf") + " -o " + path("small/mission.db3"),
            "simulate --random-rooms 12 -o " + path("small")};
  }

  /// Whether this machine lets a test mount a small disk that only it sees.
  static bool has_own_mounts() { return run_other("unshare -rm true").exit_code == 0; }
  /// Runs shell commands that see such a disk as `small`.
  static Outcome run_on_disk(const std::string& options, const std::string& commands) {
    const auto script =
        folder_->write("script.sh", "mount -t tmpfs -o " + options + " none " + path("small") +
                                        " || exit 99\n" + commands + "\n");
    return run_other("unshare -rm sh " + script.string());
  }

  static inline Folder* folder_ = nullptr;
};

const std::string kProgram = std::string(ROOMATLAS_PROGRAM) + " -q ";

TEST_F(Scarce, OnAFullDiskACommandSaysSoAndEndsOnceThereIsSpace) {
  if (!has_own_mounts()) GTEST_SKIP() << "no mounts of its own for a test here";
  for (const std::string& command : writers()) {
    for (const char* size : {"4k", "400k"}) {
      const Outcome outcome = run_on_disk(
          std::string("size=") + size,
          kProgram + command + "\nfirst=$?\nmount -o remount,size=64m " + path("small") + "\n" +
              "[ $first -eq 0 ] || " + kProgram + command + " >&2 || exit 98\nexit $first");
      EXPECT_THAT(outcome.exit_code, AnyOf(0, 3)) << size << " " << command << outcome.err;
      if (outcome.exit_code == 3) {
        EXPECT_THAT(outcome.err, HasSubstr(path("small"))) << size << " " << command;
      }
    }
  }
}

TEST_F(Scarce, AFolderThatCannotBeWrittenIsNamed) {
  if (!has_own_mounts()) GTEST_SKIP() << "no mounts of its own for a test here";
  for (const std::string& command : writers()) {
    const Outcome outcome = run_on_disk("ro", kProgram + command);
    EXPECT_EQ(outcome.exit_code, 3) << command << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(path("small"))) << command;
  }
}

TEST_F(Scarce, AStoreThatCannotBeWrittenIsReadAndNotChanged) {
  if (!has_own_mounts()) GTEST_SKIP() << "no mounts of its own for a test here";
  const std::string store = path("small/building.gpkg");
  const std::string begin = "cp " + path("built/building.gpkg") + " " + store +
                            "\nmount -o remount,ro " + path("small") + "\n" + kProgram;
  EXPECT_EQ(
      run_on_disk("size=64m", begin + "export " + store + " -f svg -o " + path("out")).exit_code,
      0);
  const std::string rename = "rename " + store + " 1 Kitchen";
  for (const std::string& command : {"assemble " + store, rename}) {
    const Outcome outcome = run_on_disk("size=64m", begin + command);
    EXPECT_EQ(outcome.exit_code, 3) << command << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(store)) << command;
  }
}

// Sanitizers reserve more than there is.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(Scarce, WithoutMemoryACommandSaysSo) {
  const std::string line(9000, '\0');
  std::string picture = "P5 9000 9000 255\n";
  for (int i = 0; i < 9000; ++i) picture += line;
  (void)folder_->write("large.pgm", picture);
  const std::string large =
      "simulate --resolution 0.05 " + path("large.pgm") + " -o " + path("out");
  std::vector<std::string> commands = writers();
  commands.push_back(large);
  for (const std::string& command : commands) {
    for (int mebibytes = 256; mebibytes <= 640; mebibytes += 128) {
      const std::string bound = "ulimit -v " + std::to_string(1024 * mebibytes) + "; ";
      const Outcome outcome = run_other(bound + kProgram + command);
      if (outcome.exit_code == 127) continue;  // its libraries found no place
      EXPECT_THAT(outcome.exit_code, AnyOf(0, 3)) << mebibytes << " " << command << outcome.err;
      EXPECT_THAT(outcome.err, Not(HasSubstr("std::"))) << mebibytes << " " << command;
    }
  }
}
#endif

}  // namespace
}  // namespace roomatlas::test
