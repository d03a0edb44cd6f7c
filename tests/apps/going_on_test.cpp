// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that are killed while they map, and the next run, against one that nobody disturbed.
#include <gmock/gmock.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

#include "child.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

namespace roomatlas::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kGoingOn = "going on after room ";
const std::string kWorldsFolder = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/";

/// How many rooms of an unfinished store are whole.
AsrId whole_rooms(const fs::path& store) {
  if (!fs::exists(store)) return 0;
  try {
    const auto unfinished = GeoPackageStore(store, GeoPackageStore::Mode::read).unfinished();
    return unfinished ? unfinished->last_asr : 0;
  } catch (const InputError&) {
    return 0;  // it is being made
  }
}

/// Stops a run once so many rooms are whole; false where it ended before.
bool stop(Child& child, const fs::path& store, AsrId rooms, int signal) {
  while (whole_rooms(store) < rooms) {
    if (child.has_ended()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  child.send({signal});
  (void)child.wait();
  return true;
}

/// Part of the demo's drive: 16 visits to 6 rooms, which take a second and more to map.
std::string short_drive(const Folder& folder) {
  const std::string drive = content_of(kWorldsFolder + "eight_rooms.drive");
  const std::size_t end = drive.find("# Lounge");
  EXPECT_NE(end, std::string::npos);
  return folder.write("short.drive", drive.substr(0, end)).string();
}

class GoingOn : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    simulate(kWorldsFolder + "eight_rooms.geojson --sensor laser --drive " + short_drive(*folder_),
             "rooms");
    ASSERT_EQ(run("-q map " + log("rooms") + " -o " + (*folder_ / "whole.gpkg").string()).exit_code,
              0);
    whole_ = content_of(*folder_ / "whole.gpkg");
    ASSERT_GT(whole_.size(), 10000U);
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static void simulate(const std::string& what, const std::string& name) {
    const Outcome made = run("-q simulate " + what + " -o " + (*folder_ / name).string());
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  static std::string log(const std::string& name) {
    return (*folder_ / name / "mission.clf").string();
  }

  [[nodiscard]] std::string map_it(const std::string& options = "") const {
    return options + " map " + log("rooms") + " -o " + store_.string();
  }
  /// The store as a run leaves it that nobody disturbs.
  void put_whole() const { std::ofstream(store_, std::ios::binary) << whole_; }
  /// What is in the folder, by name.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& [name, content] : files_in(own_ / "")) names.push_back(name);
    return names;
  }

  static inline Folder* folder_ = nullptr;
  static inline std::string whole_;  ///< bytes of the store that nobody disturbed
  Folder own_;
  fs::path store_ = own_ / "building.gpkg";
  fs::path beside_ = own_ / "building.gpkg.new";
};

TEST_F(GoingOn, ThroughALinkGoesOnInTheFileBehindIt) {
  const fs::path place = *folder_ / "linked";
  fs::create_directories(place / "disk");
  const fs::path link = place / "link.gpkg";
  const fs::path real = place / "disk/real.gpkg";
  fs::create_symlink("disk/real.gpkg", link);
  const std::string command = "map " + log("rooms") + " -o " + link.string();
  for (const std::string& unfinished : {real.string(), real.string() + ".new"}) {
    Child mapping(command);
    ASSERT_TRUE(stop(mapping, unfinished, 1, SIGINT));
    const Outcome gone_on = run(command);
    EXPECT_EQ(gone_on.exit_code, 0);
    EXPECT_THAT(gone_on.err, HasSubstr(kGoingOn));
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_TRUE(content_of(real) == whole_) << unfinished;
    EXPECT_FALSE(fs::exists(real.string() + ".new"));
    ASSERT_EQ(run("-q " + command + " --robot-width 0.3").exit_code, 0);  // to be replaced
  }
}

TEST_F(GoingOn, AfterAnySignalGivesTheBytesOfAnUndisturbedRun) {
  for (const int signal : {SIGKILL, SIGTERM, SIGINT}) {
    fs::remove(store_);
    Child child(map_it("-q"));
    ASSERT_TRUE(stop(child, store_, 3, signal)) << child.err();
    const AsrId rooms = whole_rooms(store_);
    ASSERT_GE(rooms, 3);
    const Outcome again = run(map_it());
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_THAT(again.err,
                HasSubstr(kGoingOn + std::to_string(rooms) + " of an interrupted run (reading "));
    EXPECT_TRUE(content_of(store_) == whole_) << signal;
    EXPECT_THAT(names(), ::testing::ElementsAre("building.gpkg"));
  }
}

TEST_F(GoingOn, TwiceAndAfterAnInterruptionGivesTheSameBytes) {
  for (const AsrId rooms : {2, 4, 6}) {
    Child child(map_it("-q"));
    ASSERT_TRUE(stop(child, store_, rooms, rooms == 4 ? SIGINT : SIGKILL)) << child.err();
  }
  EXPECT_THAT(run(map_it()).err, HasSubstr(kGoingOn));
  EXPECT_TRUE(content_of(store_) == whole_);
}

TEST_F(GoingOn, BesideAFinishedMapThatStaysUntilTheEnd) {
  ASSERT_EQ(run(map_it("-q --cell 0.15")).exit_code, 0);
  const std::string before = content_of(store_);
  {
    Child child(map_it("-q"));
    ASSERT_TRUE(stop(child, beside_, 2, SIGKILL)) << child.err();
  }
  EXPECT_TRUE(content_of(store_) == before);
  EXPECT_THAT(run(map_it()).err, HasSubstr(kGoingOn));
  EXPECT_TRUE(content_of(store_) == whole_);
  EXPECT_THAT(names(), ::testing::ElementsAre("building.gpkg"));
}

TEST_F(GoingOn, IsSaidInJson) {
  {
    Child child(map_it("-q"));
    ASSERT_TRUE(stop(child, store_, 2, SIGKILL)) << child.err();
  }
  const AsrId rooms = whole_rooms(store_);
  const Outcome again = run(map_it("-q --json"));
  const Json json = Json::parse(again.out);
  EXPECT_EQ(json["store"], store_.string());
  EXPECT_EQ(json["gone_on"]["mission"], "mission.clf");
  EXPECT_EQ(json["gone_on"]["after_room"], rooms);
  EXPECT_GT(json["gone_on"]["reading"], 10);
  const Json anew = Json::parse(run(map_it("-q --json") + " --force").out);
  EXPECT_TRUE(anew["gone_on"].is_null());
}

TEST_F(GoingOn, WithOtherParametersOrAnotherLogBeginsAnewAndSaysWhy) {
  {
    Child child(map_it("-q --cell 0.15"));
    ASSERT_TRUE(stop(child, store_, 2, SIGINT)) << child.err();
  }
  const fs::path kept = own_ / "kept";
  fs::copy_file(store_, kept);
  const Outcome others = run(map_it());
  EXPECT_THAT(others.err, AllOf(HasSubstr("of an interrupted run with other parameters: mapping "
                                          "from the log's begin"),
                                Not(HasSubstr(kGoingOn))));
  EXPECT_TRUE(content_of(store_) == whole_);

  fs::rename(kept, store_);
  const fs::path longer = own_ / "longer.clf";
  std::ofstream(longer) << content_of(log("rooms")) << "# one line more\n";
  const Outcome another = run("map " + longer.string() + " --cell 0.15 -o " + store_.string());
  EXPECT_EQ(another.exit_code, 0) << another.err;
  EXPECT_THAT(another.err, AllOf(HasSubstr("of an interrupted run of another log: mapping from the "
                                           "log's begin"),
                                 Not(HasSubstr(kGoingOn))));
}

TEST_F(GoingOn, WithForceBeginsAnew) {
  {
    Child child(map_it("-q"));
    ASSERT_TRUE(stop(child, store_, 2, SIGKILL)) << child.err();
  }
  EXPECT_THAT(run(map_it() + " --force").err, Not(HasSubstr(kGoingOn)));
  EXPECT_TRUE(content_of(store_) == whole_);
}

TEST_F(GoingOn, AfterTheDiskWasFull) {
  bool went_on = false;
  for (const int blocks : {200, 500, 900}) {  // of half a kilobyte
    fs::remove(store_);
    const std::string small_files = "trap '' XFSZ; ulimit -f " + std::to_string(blocks) + "; ";
    Child child(map_it("-q"), small_files);
    EXPECT_EQ(child.wait(), 0);
    EXPECT_EQ(child.exit_code(), 3) << child.err();
    const Outcome again = run(map_it());
    EXPECT_EQ(again.exit_code, 0) << again.err;
    went_on = went_on || again.err.find(kGoingOn) != std::string::npos;
    EXPECT_TRUE(content_of(store_) == whole_) << blocks;
    EXPECT_THAT(names(), ::testing::ElementsAre("building.gpkg"));
  }
  EXPECT_TRUE(went_on);
}

TEST_F(GoingOn, IntoAStoreOfAnotherVersionIsRefusedButWithForce) {
  put_whole();
  SQLite::Database(store_.string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE metadata SET value = '2' WHERE key = 'schema_version'");
  const std::string before = content_of(store_);
  const Outcome refused = run(map_it());
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("schema version 2 found, 3 expected"),
                                 HasSubstr("With --force it is replaced")));
  EXPECT_TRUE(content_of(store_) == before);
  EXPECT_EQ(run(map_it("-q") + " --force").exit_code, 0);
  EXPECT_TRUE(content_of(store_) == whole_);
}

TEST_F(GoingOn, InAStoreThatIsWholeHasNothingLeftToDo) {
  put_whole();
  EXPECT_THAT(run(map_it()).err, HasSubstr("holds this mission already"));
  EXPECT_TRUE(content_of(store_) == whole_);
}

/// The store as a run leaves it that is killed before it has finished it: all is in it, but not
/// compact.
void make_loose(const fs::path& store) {
  SQLite::Database database(store.string(), SQLite::OPEN_READWRITE);
  database.exec(
      "CREATE TABLE loose (bytes BLOB); INSERT INTO loose VALUES (zeroblob(100000)); "
      "DROP TABLE loose");
}

TEST_F(GoingOn, InAStoreThatIsWholeAndNotCompactFinishesIt) {
  put_whole();
  make_loose(store_);
  ASSERT_FALSE(content_of(store_) == whole_);
  EXPECT_THAT(run(map_it()).err, HasSubstr("holds this mission already"));
  EXPECT_TRUE(content_of(store_) == whole_);
}

/// A mission that `build` is killed in, and what it makes of it when nobody does.
struct Task {
  std::string log;
  std::map<std::string, std::string> files;
  double seconds = 0.0;
};

Task task_of(const std::string& log, const fs::path& out) {
  const auto began = std::chrono::steady_clock::now();
  EXPECT_EQ(run("-q build " + log + " -o " + out.string()).exit_code, 0);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  return {log, files_in(out), took.count()};
}

/// 100 and more are for an hour without other work.
std::uint64_t count_of_kills() {
  const char* wanted = std::getenv("ROOMATLAS_KILLS");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 6;
}

TEST_F(GoingOn, BuildOfSeveralMissionsFinishesEachStore) {
  simulate(kWorldsFolder + "two_rooms.geojson --sensor laser --tour --seed 1", "one");
  simulate(kWorldsFolder + "two_rooms.geojson --sensor laser --tour --seed 2", "two");
  const std::string both = log("one") + " " + log("two");
  const fs::path out = own_ / "built";
  const Task whole = task_of(both, out);
  make_loose(out / "missions" / "mission.gpkg");
  const fs::path other = out / "missions" / "mission-2.gpkg";
  const auto written = fs::last_write_time(other);
  ASSERT_EQ(run("-q build " + both + " -o " + out.string()).exit_code, 0);
  EXPECT_TRUE(files_in(out) == whole.files);
  EXPECT_EQ(fs::last_write_time(other), written);  // was finished: stays as it is
}

TEST_F(GoingOn, BuildKilledAtRandomMomentsEndsWithTheSameFiles) {
  simulate(
      kTwoRooms +
          " --sensor laser --tour --seed 1 --start 2.5,1.5,0 --carry-at 60 --carry-to 8.5,5,200",
      "carried");
  const std::vector<Task> tasks = {task_of(log("rooms"), *folder_ / "built"),
                                   task_of(log("carried"), *folder_ / "built_carried")};
  std::mt19937_64 random(1);
  const auto share = [&] { return static_cast<double>(random() % 1000) / 1000.0; };
  const std::uint64_t kills = count_of_kills();
  std::uint64_t killed = 0;
  std::uint64_t went_on = 0;
  for (std::uint64_t i = 0; killed < kills && i < 3 * kills; ++i) {
    const Task& task = tasks[i % 4 == 3 ? 1 : 0];
    const Folder out;
    const std::string command = "build " + task.log + " -o " + (out / "out").string();
    for (std::uint64_t again = 0; again <= i % 2; ++again) {  // every other run is killed twice
      const int signal = std::array{SIGKILL, SIGINT, SIGTERM}[random() % 3];
      Child child(command);
      const double reach = i % 3 == 0 ? 0.4 : 1.0;  // some early: rooms are mapped then
      std::this_thread::sleep_for(std::chrono::duration<double>(task.seconds * reach * share()));
      if (!child.has_ended()) ++killed;
      child.send({signal});
      (void)child.wait();
      EXPECT_THAT(child.exit_code(), AnyOf(-1, 0, 130)) << child.err();
    }
    const Outcome last = run(command);
    ASSERT_EQ(last.exit_code, 0) << last.err;
    if (last.err.find(kGoingOn) != std::string::npos) ++went_on;
    const auto files = files_in(out / "out");
    std::vector<std::string> found;
    for (const auto& [name, content] : files) found.push_back(name);
    EXPECT_EQ(files.size(), task.files.size()) << ::testing::PrintToString(found);
    for (const auto& [name, content] : task.files) {
      const auto file = files.find(name);
      EXPECT_TRUE(file != files.end() && file->second == content) << name << " of run " << i;
    }
  }
  std::printf("%d kills, %d last runs went on behind a room\n", static_cast<int>(killed),
              static_cast<int>(went_on));
  EXPECT_GE(10 * went_on, kills >= 50 ? kills : 0);
}

}  // namespace
}  // namespace roomatlas::test
