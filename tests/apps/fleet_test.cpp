// SPDX-License-Identifier: GPL-3.0-or-later
// `roomatlas-fleet` under mpirun, with ranks that are killed; where an MPI is installed.
#ifdef ROOMATLAS_FLEET

#include <gmock/gmock.h>

#include <iterator>
#include <vector>

#include "child.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;

class Fleet : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);  // mpirun asks twice
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    folder_ = new Folder;
    logs_ = log("one", "--seed 1") + " " + log("two", "--seed 2 --odometry-bias 2") + " " +
            log("three", "--seed 3");
    const std::string built = (*folder_ / "built").string();
    ASSERT_EQ(run("-q build " + logs_ + " --jobs 1 -o " + built).exit_code, 0);
    expected_ = content_of(built + "/building.gpkg");
    ASSERT_GT(expected_.size(), 10000U);
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static std::string log(const std::string& name, const std::string& flags) {
    const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/two_rooms.geojson";
    const std::string place = (*folder_ / name).string();
    EXPECT_EQ(
        run("-q simulate " + world + " --sensor laser --tour " + flags + " -o " + place).exit_code,
        0);
    std::filesystem::rename(place + "/mission.clf", place + "/" + name + ".clf");
    return place + "/" + name + ".clf";
  }

  static std::filesystem::path new_folder(const std::string& name) {
    std::filesystem::create_directory(*folder_ / name);
    return *folder_ / name;
  }
  /// What mpirun is told. Open MPI leaks, in modules that are gone when AddressSanitizer would name
  /// them: ranks are not asked for leaks.
  static std::string ranks(int count, const std::string& logs, const std::filesystem::path& out,
                           const std::string& flags = "") {
    return flags + " -x ASAN_OPTIONS=detect_leaks=0 --oversubscribe -n " + std::to_string(count) +
           " " + ROOMATLAS_FLEET + " " + logs + " --jobs 1 -o " + (out / "building.gpkg").string();
  }
  static std::string building_in(const std::filesystem::path& folder) {
    return content_of(folder / "building.gpkg");
  }

  static inline Folder* folder_ = nullptr;
  static inline std::string logs_;
  static inline std::string expected_;  ///< bytes of the building as `build` makes it
};

/// The processes that a process has started.
std::vector<pid_t> started_by(pid_t process) {
  const std::string id = std::to_string(process);
  std::ifstream in("/proc/" + id + "/task/" + id + "/children");
  return {std::istream_iterator<pid_t>(in), {}};
}

TEST_F(Fleet, GivesTheBytesOfBuildForAnyNumberOfRanks) {
  for (const int count : {1, 2}) {
    const auto out = new_folder("ranks" + std::to_string(count));
    Child fleet(ranks(count, logs_, out), "", ROOMATLAS_MPIRUN);
    fleet.wait();
    EXPECT_EQ(fleet.exit_code(), 0) << fleet.err();
    EXPECT_TRUE(building_in(out) == expected_) << count;
  }
}

TEST_F(Fleet, NamesAMissionThatFailsAndJoinsTheOthers) {
  const auto out = new_folder("failing");
  const std::string bad = folder_->write("bad.clf", "nothing of a robot\n").string();
  Child fleet(ranks(2, bad + " " + logs_, out), "", ROOMATLAS_MPIRUN);
  fleet.wait();
  EXPECT_EQ(fleet.exit_code(), 3);
  EXPECT_THAT(fleet.err(), HasSubstr("bad.clf: not in the building: is not a CARMEN log"));
  EXPECT_THAT(fleet.err(), HasSubstr("1 of 4 missions failed"));
  EXPECT_TRUE(building_in(out) == expected_);
}

TEST_F(Fleet, GoesOnWhereAKilledRunEnded) {
  const auto out = new_folder("killed");
  {
    Child fleet(ranks(1, logs_, out), "", ROOMATLAS_MPIRUN);
    ASSERT_TRUE(fleet.has_said(": mapped")) << fleet.err();
    const std::vector<pid_t> started = started_by(fleet.pid());
    ASSERT_EQ(started.size(), 1U);
    kill(started.front(), SIGKILL);  // mpirun ends all then
    fleet.wait();
  }
  ASSERT_FALSE(std::filesystem::exists(out / "building.gpkg"));
  const auto written = last_write_time(out / "missions" / "one.gpkg");
  Child again(ranks(2, logs_, out), "", ROOMATLAS_MPIRUN);
  again.wait();
  EXPECT_EQ(again.exit_code(), 0) << again.err();
  EXPECT_EQ(last_write_time(out / "missions" / "one.gpkg"), written);
  EXPECT_TRUE(building_in(out) == expected_);
}

TEST_F(Fleet, LosesARankAndNothingElse) {
  for (const std::size_t lost : {0, 2}) {  // the leader, and another
    const auto out = new_folder("lost" + std::to_string(lost));
    Child fleet(ranks(3, logs_, out, "--enable-recovery"), "", ROOMATLAS_MPIRUN);
    ASSERT_TRUE(fleet.has_said(": mapped")) << fleet.err();
    const std::vector<pid_t> started = started_by(fleet.pid());
    ASSERT_EQ(started.size(), 3U);
    kill(started[lost], SIGKILL);
    fleet.wait();
    EXPECT_THAT(fleet.err(), HasSubstr("died")) << lost;
    EXPECT_TRUE(building_in(out) == expected_) << lost;
  }
}

}  // namespace
}  // namespace roomatlas::test

#endif
