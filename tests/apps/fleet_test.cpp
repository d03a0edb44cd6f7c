// SPDX-License-Identifier: GPL-3.0-or-later
// `roomatlas-fleet` under mpirun, with ranks that are killed; where an MPI is installed.
#ifdef ROOMATLAS_FLEET

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include <iterator>
#include <vector>

#include "child.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

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

  /// The three logs again, all called run.clf.
  static std::vector<std::string> logs_of_one_name(const std::filesystem::path& place) {
    std::vector<std::string> logs;
    for (const std::string name : {"one", "two", "three"}) {
      std::filesystem::create_directories(place / name);
      std::filesystem::copy_file(*folder_ / name / (name + ".clf"), place / name / "run.clf");
      logs.push_back((place / name / "run.clf").string());
    }
    return logs;
  }
  /// The digest of the log that each store of a mission was mapped from.
  static std::map<std::string, std::string> missions_in(const std::filesystem::path& out) {
    std::map<std::string, std::string> missions;
    for (const auto& entry : std::filesystem::directory_iterator(out / "missions")) {
      if (entry.path().extension() != ".gpkg") continue;
      const GeoPackageStore store(entry.path(), GeoPackageStore::Mode::read);
      missions[entry.path().filename().string()] = store.metadata().at("mission_sha256");
    }
    return missions;
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

TEST_F(Fleet, MissionsOfOneNameKeepTheirStoresInAnyOrder) {
  const auto out = new_folder("of_one_name");
  const std::vector<std::string> logs = logs_of_one_name(out / "logs");
  const std::map<std::string, std::string> own = {{"run.gpkg", sha256_of_file(logs[0])},
                                                  {"run-2.gpkg", sha256_of_file(logs[1])},
                                                  {"run-3.gpkg", sha256_of_file(logs[2])}};
  const auto map_in_order = [&](std::vector<std::size_t> order, const std::string& flags = "") {
    std::string given;
    for (const std::size_t i : order) given += logs[i] + " ";
    Child fleet(ranks(3, given + flags, out), "", ROOMATLAS_MPIRUN);
    fleet.wait();
    EXPECT_EQ(missions_in(out), own);
    return fleet.exit_code();
  };
  EXPECT_EQ(map_in_order({0, 1, 2}), 0);
  const auto first = files_in(out);
  EXPECT_EQ(map_in_order({2, 0, 1}), 0);  // are there
  EXPECT_TRUE(files_in(out) == first);
  EXPECT_EQ(map_in_order({1, 2, 0}, "--robot-width 0.5"), 0);  // are replaced
  const std::string wide = building_in(out);
  EXPECT_FALSE(wide == first.at("building.gpkg"));
  EXPECT_EQ(map_in_order({2, 1, 0}), 0);
  EXPECT_TRUE(files_in(out) == first);
  std::filesystem::remove(logs[0]);
  EXPECT_EQ(map_in_order({0, 2, 1}), 3);  // fails, and takes no other's store
}

TEST_F(Fleet, NoMissionHangsOnTheStoresOfOthers) {
  const auto out = new_folder("others_locked");
  const std::vector<std::string> logs = logs_of_one_name(out / "logs");
  {
    Child fleet(ranks(2, logs[0] + " " + logs[1] + " " + logs[2], out), "", ROOMATLAS_MPIRUN);
    fleet.wait();
    ASSERT_EQ(fleet.exit_code(), 0) << fleet.err();
  }
  const auto before = missions_in(out);
  const auto missions = out / "missions";
  std::filesystem::remove(missions / "run.gpkg");
  std::filesystem::remove(missions / "run-2.gpkg");
  const auto expected = building_in(out);

  // The third is finished. Nobody can read it from then on, until the last has its place.
  Child fleet(ranks(1, logs[2] + " " + logs[0] + " " + logs[1], out), "", ROOMATLAS_MPIRUN);
  ASSERT_TRUE(fleet.has_said(": mapped")) << fleet.err();
  {
    constexpr int kPatienceMs = 2000;
    SQLite::Database other(missions / "run-3.gpkg", SQLite::OPEN_READWRITE, kPatienceMs);
    other.exec("BEGIN EXCLUSIVE");
    while (!std::filesystem::exists(missions / "run-2.gpkg") && !fleet.has_ended() &&
           fleet.err().find("failed") == std::string::npos) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  fleet.wait();
  EXPECT_EQ(fleet.exit_code(), 0) << fleet.err();
  EXPECT_EQ(missions_in(out), before);
  EXPECT_TRUE(building_in(out) == expected);
}

}  // namespace
}  // namespace roomatlas::test

#endif
