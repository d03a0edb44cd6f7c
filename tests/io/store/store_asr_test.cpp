// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/store/store_samples.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

using Mode = GeoPackageStore::Mode;
using testing::ElementsAre;

/// A store in which each ASR leads to the next.
std::filesystem::path store_of(const TemporaryDirectory& directory, AsrId asrs) {
  const std::filesystem::path file = directory / "building.gpkg";
  GeoPackageStore store(file, Mode::create);
  for (AsrId id = 1; id <= asrs; ++id) store.put(sample_asr(id));
  store.finish();
  return file;
}

TEST(Store, AnAsrReadsBackBitForBit) {
  const TemporaryDirectory directory;
  const GeoPackageStore store(store_of(directory, 3), Mode::read);
  EXPECT_THAT(store.ids(), ElementsAre(1, 2, 3));
  for (AsrId id = 1; id <= 3; ++id) {
    expect_same(store.get(id, AsrDetail::readings), sample_asr(id));
  }
}

TEST(Store, AnAsrReadsBackFromTheStoreThatIsStillWritten) {
  const TemporaryDirectory directory;
  GeoPackageStore store(directory / "building.gpkg", Mode::create);
  store.put(sample_asr(1));
  expect_same(store.get(1, AsrDetail::readings), sample_asr(1));
}

TEST(Store, AnEmptyAsrReadsBackEmpty) {
  const TemporaryDirectory directory;
  GeoPackageStore store(directory / "building.gpkg", Mode::create);
  Asr asr;
  asr.id = 5;
  store.put(asr);
  expect_same(store.get(5, AsrDetail::readings), asr);
}

TEST(Store, ANumberThatIsNoNumberStaysOne) {
  const TemporaryDirectory directory;
  GeoPackageStore store(directory / "building.gpkg", Mode::create);
  Asr asr = sample_asr(1);
  asr.reference_point_asr = {std::nan(""), INFINITY};
  store.put(asr);
  const Asr back = store.get(1, AsrDetail::geometry);
  EXPECT_TRUE(std::isnan(back.reference_point_asr.x()));
  EXPECT_EQ(back.reference_point_asr.y(), INFINITY);
}

TEST(Store, GivesNoMoreDetailThanAskedFor) {
  const TemporaryDirectory directory;
  const GeoPackageStore store(store_of(directory, 1), Mode::read);
  const Asr geometry = store.get(1, AsrDetail::geometry);
  expect_same_geometry(geometry, sample_asr(1));
  EXPECT_TRUE(geometry.path.empty());
  const Asr path = store.get(1, AsrDetail::path);
  EXPECT_EQ(path.path.size(), 20u);
  EXPECT_TRUE(path.readings.empty());
}

TEST(Store, ReadingsMayBeLeftOut) {
  const TemporaryDirectory directory;
  GeoPackageStore store(directory / "building.gpkg", Mode::create);
  Asr asr = sample_asr(1);
  asr.readings.clear();
  store.put(asr);
  expect_same(store.get(1, AsrDetail::readings), asr);
}

TEST(Store, EqualSensorsAreOneSharedValue) {
  const TemporaryDirectory directory;
  const GeoPackageStore store(store_of(directory, 2), Mode::read);
  const Asr first = store.get(1, AsrDetail::readings);
  const Asr second = store.get(2, AsrDetail::readings);
  EXPECT_EQ(first.readings[1].sensor, first.readings[2].sensor);
  EXPECT_EQ(first.readings[1].sensor, second.readings[1].sensor);
  EXPECT_NE(first.readings[0].sensor, first.readings[1].sensor);
}

TEST(Store, PuttingAnAsrAgainReplacesAllOfIt) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = store_of(directory, 3);
  GeoPackageStore store(file, Mode::update);
  Asr shorter = sample_asr(2, 5);
  shorter.exits.pop_back();
  store.put(shorter);
  expect_same(store.get(1, AsrDetail::readings), sample_asr(1));
  expect_same(store.get(2, AsrDetail::readings), shorter);
  expect_same(store.get(3, AsrDetail::readings), sample_asr(3));
}

TEST(Store, ReadsNoMoreOfALargeBuildingThanOfASmallOne) {
  const auto rows_for_one_asr = [](AsrId asrs) {
    const TemporaryDirectory directory;
    const GeoPackageStore store(store_of(directory, asrs), Mode::read);
    const std::int64_t before = store.rows_read();
    static_cast<void>(store.get(3, AsrDetail::readings));
    static_cast<void>(store.get(2, AsrDetail::geometry));
    return store.rows_read() - before;
  };
  // ASR, 3 exits, 20 samples, readings, 2 sensors; ASR and 3 exits
  EXPECT_EQ(rows_for_one_asr(5), 1 + 3 + 20 + 1 + 2 + 1 + 3);
  EXPECT_EQ(rows_for_one_asr(50), rows_for_one_asr(5));
}

TEST(Store, TruthKeepsItsOrderAndBecomesDurableWithTheNextAsr) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "building.gpkg";
  {
    GeoPackageStore store(file, Mode::create);
    store.put(TruePose{3.5, {1.0 / 3.0, 2, 3}});
    store.put(TruePose{1.5, {4, 5, -1}});  // time steps back
    EXPECT_TRUE(store.truth().empty());
    store.put(sample_asr(1));
    EXPECT_EQ(store.truth().size(), 2u);
    store.put(TruePose{9.5, {}});
    store.finish();
  }
  const std::vector<TruePose> truth = GeoPackageStore(file, Mode::read).truth();
  ASSERT_EQ(truth.size(), 3u);
  EXPECT_EQ(truth[0].timestamp_s, 3.5);
  EXPECT_EQ(truth[0].world_from_robot, (Pose2{1.0 / 3.0, 2, 3}));
  EXPECT_EQ(truth[1].timestamp_s, 1.5);
  EXPECT_EQ(truth[2].timestamp_s, 9.5);
}

TEST(Store, AnAsrThatIsNotThereIsAnErrorThatNamesIt) {
  const TemporaryDirectory directory;
  const GeoPackageStore store(store_of(directory, 1), Mode::read);
  try {
    static_cast<void>(store.get(17, AsrDetail::geometry));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("building.gpkg: has no ASR 17"));
  }
}

TEST(Store, WrongUseIsALogicError) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = store_of(directory, 1);
  GeoPackageStore reader(file, Mode::read);
  EXPECT_THROW(reader.put(sample_asr(2)), std::logic_error);
  GeoPackageStore writer(file, Mode::update);
  EXPECT_THROW(writer.put(Asr{}), std::logic_error);
}

}  // namespace
}  // namespace roomatlas
