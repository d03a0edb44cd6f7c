// SPDX-License-Identifier: GPL-3.0-or-later
// What people and other programs put into a store is not lost when a run replaces it.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>

#include "child.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

namespace roomatlas::test {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kNotes =
    "CREATE TABLE my_notes (id INTEGER PRIMARY KEY, note TEXT); "
    "INSERT INTO my_notes (note) VALUES ('a socket behind the door')";

/// Two missions through two rooms, and a building of the first, made once for all tests.
class ReplacedStore : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    one_ = log("one", "");
    other_ = log("other", "--seed 3");
    ASSERT_EQ(run("-q build " + one_ + " -o " + (*folder_ / "made").string()).exit_code, 0);
  }
  static void TearDownTestSuite() { delete folder_; }
  static std::string log(const std::string& name, const std::string& options) {
    const fs::path out = *folder_ / name;
    EXPECT_EQ(run("-q simulate " + kTwoRooms + " --sensor laser " + options + " -o " + out.string())
                  .exit_code,
              0);
    fs::copy_file(out / "mission.clf", *folder_ / (name + ".clf"));
    return (*folder_ / (name + ".clf")).string();
  }
  /// A copy of the building in a folder of this test's own.
  static std::string building() {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::copy(*folder_ / "made", *folder_ / name, fs::copy_options::recursive);
    return (*folder_ / name).string();
  }
  static std::string first_room(const fs::path& store) {
    return GeoPackageStore(store, GeoPackageStore::Mode::read).plan().rooms[0].name;
  }

  static inline Folder* folder_ = nullptr;
  static inline std::string one_;
  static inline std::string other_;
};

TEST_F(ReplacedStore, OneThatAnotherProgramHasOpenIsNotTouched) {
  const std::string place = building();
  const std::string store = place + "/building.gpkg";
  SQLite::Database qgis(store, SQLite::OPEN_READWRITE);
  qgis.exec("PRAGMA journal_mode = WAL; PRAGMA wal_autocheckpoint = 0");
  qgis.exec(kNotes);
  for (const std::string& command :
       {"map " + one_ + " -o " + store, "build " + one_ + " --robot-width 0.3 -o " + place,
        "rename " + store + " 1 Kitchen", "assemble " + store}) {
    const Outcome outcome = run("-q " + command);
    EXPECT_EQ(outcome.exit_code, 3) << command;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(store), HasSubstr("another program has it open")));
  }
  qgis.exec("INSERT INTO my_notes (note) VALUES ('another')");
  EXPECT_EQ(qgis.execAndGet("SELECT count(*) FROM my_notes").getInt(), 2);
  EXPECT_EQ(qgis.execAndGet("SELECT name FROM rooms WHERE id = 1").getString(), "1");
}

TEST_F(ReplacedStore, OneThatAnotherProgramWritesToIsNotTouched) {
  const std::string store = building() + "/building.gpkg";
  SQLite::Database other(store, SQLite::OPEN_READWRITE);
  other.exec("BEGIN IMMEDIATE");
  other.exec(kNotes);
  const Outcome outcome = run("-q rename " + store + " 1 Kitchen");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("another program has it open"));
  other.exec("COMMIT");
  EXPECT_EQ(run("-q rename " + store + " 1 Kitchen").exit_code, 0);
  EXPECT_EQ(other.execAndGet("SELECT count(*) FROM my_notes").getInt(), 1);
}

TEST_F(ReplacedStore, OneThatAnotherProgramOpensWhileItIsMappedIsNotTouched) {
  const std::string store = building() + "/building.gpkg";
  fs::permissions(store, fs::perms::owner_read | fs::perms::owner_write);
  Child mapping("map " + one_ + " --robot-width 0.3 -o " + store);
  ASSERT_TRUE(mapping.has_said("map ...")) << mapping.err();
  mapping.pause();
  {
    SQLite::Database qgis(store, SQLite::OPEN_READWRITE);
    qgis.exec("PRAGMA journal_mode = WAL; PRAGMA wal_autocheckpoint = 0");
    qgis.exec(kNotes);
    EXPECT_EQ(fs::status(store + ".new").permissions(), fs::status(store).permissions());
    mapping.resume();
    EXPECT_EQ(mapping.wait(), 0);
    EXPECT_EQ(mapping.exit_code(), 3);
    EXPECT_THAT(mapping.err(), AllOf(HasSubstr("another program has it open"),
                                     HasSubstr("the next run goes on from there")));
    EXPECT_EQ(qgis.execAndGet("SELECT count(*) FROM my_notes").getInt(), 1);
  }
  const Outcome again = run("map " + one_ + " --robot-width 0.3 -o " + store);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.err, AllOf(HasSubstr("holds this mission already"),
                               HasSubstr("it holds what the new one has not: the table my_notes")));
}

TEST_F(ReplacedStore, KeepsWhatWasSaidWhileAFinishedMapWaitedForIt) {
  const std::string store = building() + "/building.gpkg";
  {
    Child mapping("map " + one_ + " --robot-width 0.3 -o " + store);
    ASSERT_TRUE(mapping.has_said("map ...")) << mapping.err();
    mapping.pause();
    SQLite::Database qgis(store, SQLite::OPEN_READWRITE);
    qgis.exec("PRAGMA journal_mode = WAL");
    EXPECT_EQ(qgis.execAndGet("SELECT count(*) FROM rooms").getInt(), 2);
    mapping.resume();
    EXPECT_EQ(mapping.wait(), 0);
    ASSERT_EQ(mapping.exit_code(), 3);
    qgis.exec("PRAGMA journal_mode = DELETE; UPDATE rooms SET name = 'Office' WHERE id = 2");
  }
  ASSERT_TRUE(fs::exists(store + ".new"));
  const std::string kinds = (*folder_ / "waiting.json").string();
  std::ofstream(kinds) << R"({"format": "roomatlas-edits", "version": 1, "frame": "building",
    "edits": [{"edit": "set_room_kind", "room": {"id": 1}, "kind": "hall"}]})";
  ASSERT_EQ(run("-q assemble " + store + " --edits " + kinds).exit_code, 0);
  const Outcome again = run("map " + one_ + " --robot-width 0.3 -o " + store);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.err, HasSubstr("building.former.gpkg: it holds what the new one has not: the "
                                   "room \"Office\", 1 correction by hand"));
}

TEST_F(ReplacedStore, OfTheSameLogThatIsDamagedStaysBeside) {
  const std::string place = building();
  const std::string store = place + "/building.gpkg";
  ASSERT_EQ(run("-q rename " + store + " 1 Kitchen").exit_code, 0);
  SQLite::Database(store, SQLite::OPEN_READWRITE)
      .exec("UPDATE rooms SET geom = x'00' WHERE id = 2");
  const Outcome built = run("build " + one_ + " --robot-width 0.3 -o " + place);
  EXPECT_EQ(built.exit_code, 0);
  EXPECT_THAT(built.err, HasSubstr("building.former.gpkg: it holds what the new one has not: what "
                                   "cannot be read"));
  EXPECT_EQ(SQLite::Database(place + "/building.former.gpkg")
                .execAndGet("SELECT name FROM rooms WHERE id = 1")
                .getString(),
            "Kitchen");
}

TEST_F(ReplacedStore, DoesNotStayWithoutTables) {  // as a kill leaves one that was just begun
  const std::string place = (*folder_ / "begun").string();
  fs::create_directory(place);
  SQLite::Database(place + "/building.gpkg", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("PRAGMA journal_mode = WAL");
  ASSERT_GT(fs::file_size(place + "/building.gpkg"), 0U);
  const Outcome built = run("build " + one_ + " -o " + place);
  EXPECT_EQ(built.exit_code, 0) << built.err;
  EXPECT_FALSE(fs::exists(place + "/building.former.gpkg"));
  EXPECT_THAT(built.err, Not(HasSubstr("former")));
}

TEST_F(ReplacedStore, StaysBesideWithTheTablesOfOthers) {
  const std::string place = building();
  SQLite::Database(place + "/building.gpkg", SQLite::OPEN_READWRITE).exec(kNotes);
  const Outcome built = run("build " + one_ + " --robot-width 0.3 -o " + place);
  EXPECT_EQ(built.exit_code, 0);
  EXPECT_THAT(built.err, HasSubstr("building.former.gpkg: it holds what the new one has not: the "
                                   "table my_notes"));
  EXPECT_EQ(SQLite::Database(place + "/building.former.gpkg")
                .execAndGet("SELECT note FROM my_notes")
                .getString(),
            "a socket behind the door");
  const Outcome again = run("build " + one_ + " --robot-width 0.4 -o " + place);
  EXPECT_THAT(again.err, Not(HasSubstr("former")));  // nothing of anybody is in it
  SQLite::Database(place + "/building.gpkg", SQLite::OPEN_READWRITE)
      .exec(
          "ALTER TABLE rooms ADD COLUMN department TEXT; CREATE TABLE gpkg_metadata (id INTEGER)");
  EXPECT_THAT(run("build " + one_ + " --robot-width 0.3 -o " + place).err,
              HasSubstr("building.former-2.gpkg: it holds what the new one has not: the table "
                        "gpkg_metadata, the column department of the table rooms"));
  SQLite::Database(place + "/building.gpkg", SQLite::OPEN_READWRITE)
      .exec("UPDATE layer_styles SET styleQML = '<qgis/>' WHERE f_table_name = 'rooms'");
  EXPECT_THAT(run("build " + one_ + " -o " + place + " --robot-width 0.5").err,
              HasSubstr("building.former-3.gpkg: it holds what the new one has not: the table "
                        "layer_styles"));
}

TEST_F(ReplacedStore, OfAnotherBuildingStaysBesideWithItsNames) {
  const std::string place = building();
  const std::string store = place + "/building.gpkg";
  ASSERT_EQ(run("-q rename " + store + " 1 Kitchen").exit_code, 0);
  const Outcome built = run("build " + other_ + " -o " + place);
  EXPECT_EQ(built.exit_code, 0);
  EXPECT_THAT(built.err, HasSubstr("the room \"Kitchen\", 1 correction by hand"));
  EXPECT_EQ(first_room(store), "1");
  EXPECT_EQ(first_room(place + "/building.former.gpkg"), "Kitchen");
}

TEST_F(ReplacedStore, OfTheSameLogThatIsPackedNowKeepsItsNames) {
  const std::string place = building();
  const std::string store = place + "/building.gpkg";
  ASSERT_EQ(run("-q rename " + store + " 1 Kitchen").exit_code, 0);
  const std::string packed = (*folder_ / "one.clf.gz").string();
  ASSERT_EQ(std::system(("gzip -c " + one_ + " > " + packed).c_str()), 0);
  EXPECT_THAT(run("build " + packed + " -o " + place).err,
              AllOf(HasSubstr("holds this mission already"), Not(HasSubstr("former"))));
  EXPECT_EQ(first_room(store), "Kitchen");
}

TEST_F(ReplacedStore, KeepsItsPermissionsAndTheLinkToIt) {
  const std::string place = building();
  const fs::path real = place + "/real.gpkg";
  const fs::path link = place + "/building.gpkg";
  fs::rename(link, real);
  fs::create_symlink("real.gpkg", link);
  const fs::perms mine = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(real, mine);
  for (const std::string& command :
       {"rename " + link.string() + " 1 Kitchen", "assemble " + link.string(),
        "build " + one_ + " -o " + place, "build " + one_ + " --force -o " + place,
        "map " + one_ + " --robot-width 0.3 -o " + link.string(), "assemble " + link.string()}) {
    ASSERT_EQ(run("-q " + command).exit_code, 0) << command;
    EXPECT_TRUE(fs::is_symlink(link)) << command;
    EXPECT_EQ(fs::status(real).permissions(), mine) << command;
  }
  EXPECT_EQ(first_room(real), "Kitchen");
  fs::permissions(real, fs::perms::owner_read);  // the next one is written nevertheless
  ASSERT_EQ(run("-q build " + one_ + " --robot-width 0.4 -o " + place).exit_code, 0);
  EXPECT_EQ(fs::status(real).permissions(), mine);
  const std::string lock = real.string() + ".lock";  // of both names
  const int other_run = open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_EQ(flock(other_run, LOCK_EX | LOCK_NB), 0);
  EXPECT_THAT(run("rename " + link.string() + " 1 Pantry").err, HasSubstr("another run"));
  close(other_run);
}

TEST_F(ReplacedStore, ALinkToNothingIsFilled) {
  const fs::path link = *folder_ / "link.gpkg";
  const fs::path target = *folder_ / "behind_the_link.gpkg";
  fs::create_symlink("behind_the_link.gpkg", link);
  ASSERT_EQ(run("-q map " + one_ + " -o " + link.string()).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(fs::is_regular_file(target));
  ASSERT_EQ(run("-q assemble " + link.string()).exit_code, 0);
  EXPECT_EQ(GeoPackageStore(target, GeoPackageStore::Mode::read).plan().rooms.size(), 2U);
}

TEST_F(ReplacedStore, MissionsOfOneNameKeepTheirStoresInAnyOrder) {
  const fs::path place = *folder_ / "names";
  for (const char* name : {"one", "other"}) {
    fs::create_directories(place / name);
    fs::copy_file(*folder_ / (std::string(name) + ".clf"), place / name / "run.clf");
  }
  const std::string a = (place / "one/run.clf").string();
  const std::string b = (place / "other/run.clf").string();
  const std::string out = (place / "out").string();
  ASSERT_EQ(run("-q build " + a + " " + b + " -o " + out).exit_code, 0);
  ASSERT_EQ(run("-q rename " + out + "/missions/run.gpkg 1 Mine").exit_code, 0);
  const std::string bytes = content_of(out + "/missions/run.gpkg");
  ASSERT_EQ(run("-q build " + b + " " + a + " -o " + out).exit_code, 0);
  EXPECT_EQ(content_of(out + "/missions/run.gpkg"), bytes);
  // of two of that name one alone takes its own, and of others none
  ASSERT_EQ(run("-q build " + b + " " + one_ + " -o " + out).exit_code, 0);
  EXPECT_EQ(content_of(out + "/missions/run.gpkg"), bytes);
  EXPECT_EQ(GeoPackageStore(out + "/missions/run-2.gpkg", GeoPackageStore::Mode::read)
                .metadata()
                .at("mission_sha256"),
            sha256_of_file(b));
  // nor where the stores before its own are gone
  fs::remove(out + "/missions/run.gpkg");
  EXPECT_THAT(run("build " + b + " " + one_ + " -o " + out).err,
              HasSubstr("run-2.gpkg holds this mission already"));
  EXPECT_FALSE(fs::exists(out + "/missions/run.gpkg"));
}

TEST_F(ReplacedStore, ALogThatGrowsWhileItIsMappedIsRefused) {
  const std::string place = (*folder_ / "grows").string();
  const std::string grown = (*folder_ / "grows.clf").string();
  fs::copy_file(one_, grown);
  Child mapping("map " + grown + " -o " + place + ".gpkg");
  ASSERT_TRUE(mapping.has_said("map ...")) << mapping.err();
  mapping.pause();
  std::ofstream(grown, std::ios::app) << content_of(other_);
  mapping.resume();
  EXPECT_EQ(mapping.wait(), 0);
  EXPECT_EQ(mapping.exit_code(), 3);
  EXPECT_THAT(mapping.err(), HasSubstr(grown + ": was written to while it was read"));
  EXPECT_FALSE(fs::exists(place + ".gpkg"));
}

TEST_F(ReplacedStore, WhatElseIsPutIntoTheFolderOfARecordingMattersNothing) {
  const std::string recording = (*folder_ / "recording").string();
  const std::string store = (*folder_ / "of_recording.gpkg").string();
  ASSERT_EQ(run("-q convert " + one_ + " -o " + recording).exit_code, 0);
  ASSERT_TRUE(fs::is_directory(recording));
  Child mapping("map " + recording + " -o " + store);
  ASSERT_TRUE(mapping.has_said("map ...")) << mapping.err();
  std::ofstream(recording + "/notes.txt") << "of somebody else";
  EXPECT_EQ(mapping.wait(), 0);
  EXPECT_EQ(mapping.exit_code(), 0) << mapping.err();
}

TEST_F(ReplacedStore, FilesOfAnEarlierRunAreNamed) {
  const std::string place = building();
  const Outcome earth = run("build " + one_ + " --georef 48,7,10 -o " + place);
  EXPECT_THAT(earth.err, Not(HasSubstr("of an earlier run")));
  const Outcome plain = run("build " + one_ + " -o " + place);
  EXPECT_THAT(plain.err, HasSubstr("of an earlier run, and not written now: plan.geojson\n"));
  fs::remove(place + "/plan.geojson");
  fs::create_directories(place + "/beside/corridor");
  fs::copy_file(place + "/building.gpkg", place + "/building.2.gpkg");
  EXPECT_THAT(run("build " + one_ + " -o " + place).err,
              HasSubstr("not written now: beside/corridor, building.2.gpkg\n"));
}

TEST_F(ReplacedStore, ATruthThatIsNotThereIsSaidBeforeAnythingIsMapped) {
  const fs::path place = *folder_ / "no_truth";
  const Outcome built = run("build " + one_ + " --truth nowhere.tum -o " + place.string());
  EXPECT_EQ(built.exit_code, 3);
  EXPECT_THAT(built.err, HasSubstr("nowhere.tum: there is no such file"));
  EXPECT_FALSE(fs::exists(place));
}

}  // namespace
}  // namespace roomatlas::test
