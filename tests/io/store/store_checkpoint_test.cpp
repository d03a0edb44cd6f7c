// SPDX-License-Identifier: GPL-3.0-or-later
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include "io/store/store_samples.hpp"

namespace roomatlas {
namespace {

using Mode = GeoPackageStore::Mode;

class StoreCheckpoint : public testing::Test {
 protected:
  /// ASRs 1 to 2 with checkpoints, and one that an interrupted run cut.
  void write_unfinished(const std::filesystem::path& file) const {
    GeoPackageStore store(file, Mode::create);
    store.put_origin(origin_);
    for (AsrId id = 1; id <= 2; ++id) put(store, id);
    store.put(TruePose{3.0, {}});
    store.put(sample_asr(3, 5));
    store.put_metadata({{"mission_file", "cut.clf"}});
  }
  static void put(GeoPackageStore& store, AsrId id) {
    store.put(TruePose{static_cast<double>(id), {}});
    store.put(sample_asr(id), "checkpoint " + std::to_string(id) + std::string("\0\xff", 2));
  }

  TemporaryDirectory directory_;
  std::filesystem::path file_ = directory_ / "building.gpkg";
  const std::map<std::string, std::string> origin_ = {{"mission_sha256", "abc"},
                                                      {"tool_version", "1"}};
};

TEST_F(StoreCheckpoint, IsThatOfTheLastAsrThatBroughtOne) {
  write_unfinished(file_);
  const GeoPackageStore store(file_, Mode::read);
  const auto unfinished = store.unfinished();
  ASSERT_TRUE(unfinished);
  EXPECT_EQ(unfinished->last_asr, 2);
  EXPECT_EQ(unfinished->checkpoint, "checkpoint 2" + std::string("\0\xff", 2));
  EXPECT_EQ(unfinished->origin, origin_);
}

TEST_F(StoreCheckpoint, OnceItIsGoneBackToTheRestGivesTheBytesOfAnUndisturbedRun) {
  write_unfinished(file_);
  {
    GeoPackageStore store(file_, Mode::update);
    store.go_back_to_checkpoint();
    EXPECT_THAT(store.ids(), testing::ElementsAre(1, 2));
    EXPECT_EQ(store.truth().size(), 2U);
    EXPECT_FALSE(store.metadata().contains("mission_file"));
    for (AsrId id = 3; id <= 4; ++id) put(store, id);
    store.put_metadata({{"mission_file", "whole.clf"}});
    store.finish();
  }
  const std::filesystem::path plain = directory_ / "plain.gpkg";
  GeoPackageStore store(plain, Mode::create);  // that never knew of checkpoints
  for (AsrId id = 1; id <= 4; ++id) {
    store.put(TruePose{static_cast<double>(id), {}});
    store.put(sample_asr(id));
  }
  store.put_metadata({{"mission_file", "whole.clf"}});
  store.finish();
  EXPECT_TRUE(bytes_of(file_) == bytes_of(plain));
  EXPECT_FALSE(GeoPackageStore(file_, Mode::read).unfinished());
}

TEST_F(StoreCheckpoint, GoesWithAnAssembly) {
  write_unfinished(file_);
  GeoPackageStore store(file_, Mode::update);
  store.put(Assembly{}, "");
  EXPECT_FALSE(store.unfinished());
}

TEST_F(StoreCheckpoint, WithAnotherSumIsRefused) {
  write_unfinished(file_);
  SQLite::Database(file_.string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE checkpoint SET state = x'00'");
  const GeoPackageStore store(file_, Mode::read);
  try {
    (void)store.unfinished();
    FAIL() << "it was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("table checkpoint, row 1, field crc32"));
  }
}

TEST_F(StoreCheckpoint, IsNoneInANewStore) {
  const GeoPackageStore store(file_, Mode::create);
  EXPECT_FALSE(store.unfinished());
}

}  // namespace
}  // namespace roomatlas
