// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/store/assembly_samples.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

using Mode = GeoPackageStore::Mode;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

void fill(GeoPackageStore& store) {
  for (AsrId id = 1; id <= 4; ++id) {
    store.put(TruePose{static_cast<double>(id), {1, 2, 3}});
    store.put(sample_asr(id));
  }
  store.put_metadata({{"tool_version", "0.1.0"}, {"input_sha256", "abc"}});
  store.put(sample_assembly(sample_correction(4), sample_plan(), {{1, 1}, {2, 1}}), "");
}

std::string error_of_opening(const std::filesystem::path& file, Mode mode) {
  try {
    const GeoPackageStore store(file, mode);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(StoreFile, TheSameCallsGiveTheSameBytes) {
  const TemporaryDirectory directory;
  for (const char* name : {"a.gpkg", "b.gpkg"}) {
    GeoPackageStore store(directory / name, Mode::create);
    fill(store);
    store.finish();
  }
  EXPECT_GT(bytes_of(directory / "a.gpkg").size(), 10000u);
  EXPECT_TRUE(bytes_of(directory / "a.gpkg") == bytes_of(directory / "b.gpkg"));
}

TEST(StoreFile, TheSameContentGivesTheSameBytesHoweverItCameAbout) {
  const TemporaryDirectory directory;
  {
    GeoPackageStore store(directory / "a.gpkg", Mode::create);
    fill(store);
    store.finish();
  }
  {
    GeoPackageStore(directory / "b.gpkg", Mode::create).put(sample_asr(99));
    GeoPackageStore store(directory / "b.gpkg", Mode::create);
    store.put_metadata({{"tool_version", "0.0.1"}, {"input_sha256", "ab"}});
    store.put(sample_assembly(sample_correction(2), sample_plan()), "another");
    store.put(TruePose{1.0, {1, 2, 3}});
    store.put(sample_asr(1));
  }
  for (const bool rest : {true, false}) {  // finished twice
    GeoPackageStore store(directory / "b.gpkg", Mode::update);
    for (AsrId id = 2; rest && id <= 4; ++id) {
      store.put(TruePose{static_cast<double>(id), {1, 2, 3}});
      store.put(sample_asr(id, 3));
      store.put(sample_asr(id));
    }
    store.put_metadata({{"tool_version", "0.1.0"}, {"input_sha256", "abc"}});
    store.put(sample_assembly(sample_correction(4), sample_plan(), {{1, 1}, {2, 1}}), "");
    store.finish();
  }
  EXPECT_TRUE(bytes_of(directory / "a.gpkg") == bytes_of(directory / "b.gpkg"));
}

/// As `kill -9` leaves it: pages of a change are in the file, and those before it in its journal.
TEST(StoreFile, AChangeThatWasKilledIsTakenBack) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "a.gpkg";
  const std::filesystem::path killed = directory / "killed.gpkg";
  {
    GeoPackageStore store(file, Mode::create);
    fill(store);
    store.finish();
  }
  {
    SQLite::Database changing(file.string(), SQLite::OPEN_READWRITE);
    changing.exec("PRAGMA cache_size = 1; BEGIN; UPDATE metadata SET value = 'none'");
    changing.exec("INSERT INTO metadata (key, value) VALUES ('much', hex(randomblob(200000)))");
    std::filesystem::copy_file(file, killed);
    std::filesystem::copy_file(file.string() + "-journal", killed.string() + "-journal");
  }
  ASSERT_NE(bytes_of(killed), bytes_of(file));
  EXPECT_EQ(GeoPackageStore(killed, Mode::read).metadata(),
            GeoPackageStore(file, Mode::read).metadata());
  EXPECT_FALSE(std::filesystem::exists(killed.string() + "-journal"));
  EXPECT_EQ(bytes_of(killed), bytes_of(file));
}

TEST(StoreFile, FinishingLeavesOneFileOutOfWalMode) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "building.gpkg";
  GeoPackageStore store(file, Mode::create);
  fill(store);
  const std::int64_t rows = store.rows_read();
  store.finish();
  EXPECT_GE(store.rows_read(), rows);
  EXPECT_THROW(static_cast<void>(store.ids()), std::logic_error);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}), 1);
  EXPECT_EQ(bytes_of(file).substr(18, 2), "\x01\x01");  // header: rollback journal
}

TEST(StoreFile, IsFinishedUntilItIsOpenedForWriting) {
  const TemporaryDirectory directory;
  const auto is_finished = [&] {
    return GeoPackageStore(directory / "a.gpkg", Mode::read).is_finished();
  };
  {
    GeoPackageStore store(directory / "a.gpkg", Mode::create);
    fill(store);
    EXPECT_FALSE(is_finished());
    store.finish();
    EXPECT_TRUE(store.is_finished());
  }
  EXPECT_TRUE(is_finished());
  { const GeoPackageStore store(directory / "a.gpkg", Mode::update); }
  EXPECT_FALSE(is_finished());
  GeoPackageStore(directory / "a.gpkg", Mode::update).finish();
  EXPECT_TRUE(is_finished());
}

TEST(StoreFile, ClosingWithoutFinishingLeavesAStoreThatOpens) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "building.gpkg";
  GeoPackageStore(file, Mode::create).put(sample_asr(1));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}), 1);
  expect_same(GeoPackageStore(file, Mode::read).get(1, AsrDetail::readings), sample_asr(1));
}

TEST(StoreFile, AReadOnlyStoreOpensForReading) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "building.gpkg";
  GeoPackageStore store(file, Mode::create);
  fill(store);
  store.finish();
  const std::string before = bytes_of(file);
  std::filesystem::permissions(file, std::filesystem::perms::owner_read);
  EXPECT_EQ(GeoPackageStore(file, Mode::read).ids().size(), 4u);
  EXPECT_TRUE(bytes_of(file) == before);
}

TEST(StoreFile, IsAGeoPackageOfVersion13) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "building.gpkg";
  GeoPackageStore store(file, Mode::create);
  fill(store);
  store.finish();
  SQLite::Database db(file.string());
  EXPECT_EQ(db.execAndGet("PRAGMA application_id").getInt(), 0x47504B47);
  EXPECT_EQ(db.execAndGet("PRAGMA user_version").getInt(), 10300);
  EXPECT_EQ(db.execAndGet("PRAGMA integrity_check").getString(), "ok");
  EXPECT_EQ(db.execAndGet("SELECT count(*) FROM pragma_foreign_key_check").getInt(), 0);
  EXPECT_EQ(db.execAndGet("SELECT count(*) FROM gpkg_spatial_ref_sys "
                          "WHERE srs_id IN (-1, 0, 4326)")
                .getInt(),
            3);
  EXPECT_EQ(db.execAndGet("SELECT organization FROM gpkg_spatial_ref_sys JOIN "
                          "gpkg_geometry_columns USING (srs_id) "
                          "WHERE table_name = 'rooms'")
                .getString(),
            "ROOMATLAS");
}

TEST(StoreFile, IsDatedByTheMissionAndNeverByTheClock) {
  const TemporaryDirectory directory;
  const auto date_of = [&](double start_s) {
    const std::filesystem::path file = directory / "building.gpkg";
    GeoPackageStore store(file, Mode::create);
    Asr asr = sample_asr(1);
    asr.start_s = start_s;
    store.put(asr);
    store.finish();
    SQLite::Database db(file.string());
    return db.execAndGet("SELECT min(last_change) || max(last_change) FROM gpkg_contents")
        .getString();
  };
  const std::string mission = "2003-05-27T01:46:40.250Z";
  EXPECT_EQ(date_of(1054000000.25), mission + mission);
  const std::string unknown = "1970-01-01T00:00:00.000Z";
  EXPECT_EQ(date_of(17.0), unknown + unknown);
  EXPECT_EQ(date_of(std::nan("")), unknown + unknown);
}

TEST(StoreFile, MetadataKeysAreUniqueAndTheLastValueHolds) {
  const TemporaryDirectory directory;
  GeoPackageStore store(directory / "building.gpkg", Mode::create);
  store.put_metadata({{"configuration", "a = 1\nb = \"\xc3\xbc\"\n"}, {"empty", ""}});
  store.put_metadata({{"configuration", "a = 2"}, {"schema_version", "3"}});
  const std::map<std::string, std::string> expected = {
      {"configuration", "a = 2"}, {"empty", ""}, {"schema_version", "3"}};
  EXPECT_EQ(store.metadata(), expected);
  EXPECT_THROW(store.put_metadata({{"schema_version", "1"}}), std::logic_error);
}

TEST(StoreFile, CreateReplacesWhatIsThere) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "building.gpkg";
  std::ofstream(file) << "something else";
  const GeoPackageStore store(file, Mode::create);
  EXPECT_TRUE(store.ids().empty());
}

TEST(StoreFile, BadFilesAreNamedInOneLineWithARemedy) {
  const TemporaryDirectory directory;
  const std::filesystem::path text = directory / "mission.clf";
  std::ofstream(text) << "# a log, not a store, of more than one hundred bytes: SQLite reads that "
                         "many before it can tell that this is none of its files\n";
  const std::filesystem::path empty = directory / "empty.gpkg";
  std::ofstream(empty).close();
  const std::filesystem::path other = directory / "other.gpkg";
  SQLite::Database(other.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("PRAGMA application_id = 0x47504B47; CREATE TABLE roads (id INTEGER PRIMARY KEY)");
  const std::filesystem::path missing = directory / "missing.gpkg";
  for (const Mode mode : {Mode::read, Mode::update}) {
    const auto message = [&](const std::filesystem::path& file) {
      return error_of_opening(file, mode);
    };
    EXPECT_THAT(message(text), AllOf(HasSubstr("mission.clf: not a building store"),
                                     HasSubstr("roomatlas map"), Not(HasSubstr("\n"))));
    EXPECT_THAT(message(empty), HasSubstr("empty.gpkg: not a building store: found an empty"));
    EXPECT_THAT(message(other), HasSubstr("other.gpkg: not a building store: found a GeoPackage"));
    EXPECT_THAT(message(missing), HasSubstr("missing.gpkg: no such file"));
    EXPECT_FALSE(std::filesystem::exists(missing));
  }
  EXPECT_THAT(error_of_opening(text.parent_path(), Mode::create), HasSubstr("is a directory"));
  EXPECT_THAT(error_of_opening(directory / "no/such/x.gpkg", Mode::create),
              HasSubstr("x.gpkg: cannot be opened"));
}

/// @param value as SQL has it
std::string error_of_schema_version(const std::string& value) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "building.gpkg";
  GeoPackageStore(file, Mode::create).finish();
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE metadata SET value = " + value + " WHERE key = 'schema_version'");
  return error_of_opening(file, Mode::read);
}

TEST(StoreFile, AnotherSchemaVersionIsRefusedNamingBoth) {
  EXPECT_THAT(error_of_schema_version("'999'"),
              AllOf(HasSubstr("building.gpkg: schema version 999 found, 3 expected"),
                    Not(HasSubstr("\n"))));
}

TEST(StoreFile, ASchemaVersionThatIsNoTextIsADamagedStore) {
  EXPECT_THAT(error_of_schema_version("x'3300'"),
              HasSubstr("building.gpkg: table metadata, row 1, field value: found bytes, expected "
                        "text: the store is damaged"));
}

TEST(StoreFile, DamagedReadingsAreAnInputErrorThatNamesTheFile) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "building.gpkg";
  GeoPackageStore(file, Mode::create).put(sample_asr(1));
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE readings SET deflated = x'00010203'");
  const GeoPackageStore store(file, Mode::read);
  EXPECT_THROW(static_cast<void>(store.get(1, AsrDetail::readings)), InputError);
  expect_same_geometry(store.get(1, AsrDetail::path), sample_asr(1));
}

}  // namespace
}  // namespace roomatlas
