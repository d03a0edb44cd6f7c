// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/store/assembly_samples.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/store/room_names.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

namespace roomatlas {
namespace {

using Mode = GeoPackageStore::Mode;

class StoredAssembly : public testing::Test {
 protected:
  StoredAssembly() {
    for (AsrId id = 1; id <= 3; ++id) store_.put(sample_asr(id));
  }
  TemporaryDirectory directory_;
  std::filesystem::path file_ = directory_ / "building.gpkg";
  GeoPackageStore store_{file_, Mode::create};
};

TEST_F(StoredAssembly, CorrectionAndPlanReadBackBitForBitWithHoles) {
  store_.put(sample_assembly(sample_correction(3), sample_plan()), "");
  store_.finish();
  const GeoPackageStore store(file_, Mode::read);
  EXPECT_TRUE(store.has_assembly());
  expect_same(store.correction(), sample_correction(3));
  expect_same(store.plan(), sample_plan());
  EXPECT_EQ(store.plan().rooms[0].parts[0].holes.size(), 1u);
}

TEST_F(StoredAssembly, ThePlanAsMeasuredStandsBesideTheOtherAndSharesItsNames) {
  Assembly assembly = sample_assembly(sample_correction(3), sample_plan());
  store_.put(assembly, "");
  expect_same(store_.measured_plan(), sample_plan());  // there is none
  FloorPlan measured = sample_plan();
  measured.walls.pop_back();
  measured.rooms[0].area_m2 += 1.0;
  assembly.measured_plan = measured;
  store_.put(assembly, "");
  store_.finish();
  rename_room(file_, measured.rooms[0].id, "Kitchen", "");
  measured.rooms[0].name = "Kitchen";
  const GeoPackageStore store(file_, Mode::read);
  expect_same(store.measured_plan(), measured);
  EXPECT_EQ(store.plan().walls.size(), sample_plan().walls.size());
}

TEST_F(StoredAssembly, ThePlacesOfTheOtherAnswerReadBackBitForBitAndGoWithTheNext) {
  Assembly assembly = sample_assembly(sample_correction(3), sample_plan());
  assembly.other_answer = {{1, {}}, {2, {1.0 / 3.0, -2e-9, 3.1}}, {3, {41.5, 7.0, -0.25}}};
  store_.put(assembly, "");
  store_.finish();
  EXPECT_EQ(GeoPackageStore(file_, Mode::read).other_answer(), assembly.other_answer);
  GeoPackageStore again(file_, Mode::update);
  again.put(sample_assembly(sample_correction(3), sample_plan()), "");
  EXPECT_TRUE(again.other_answer().empty());
}

TEST_F(StoredAssembly, ANewOneReplacesTheFormerWithoutATrace) {
  Assembly former = sample_assembly(sample_correction(3), sample_plan(), {{1, 5}, {2, 5}, {3, 6}});
  former.measured_plan = sample_plan();
  store_.put(former, "");
  FloorPlan smaller;
  smaller.title = "again";
  store_.put(sample_assembly(sample_correction(1), smaller, {{2, 9}}), "");
  expect_same(store_.plan(), smaller);
  expect_same(store_.measured_plan(), smaller);
  expect_same(store_.correction(), sample_correction(1));
  EXPECT_EQ(store_.get(1, AsrDetail::geometry).room, 0);
  EXPECT_EQ(store_.get(2, AsrDetail::geometry).room, 9);
  EXPECT_EQ(store_.get(3, AsrDetail::geometry).room, 0);
}

TEST_F(StoredAssembly, LeavesTheAsrsAsTheyWereApartFromTheirRoom) {
  store_.put(sample_assembly(sample_correction(3), sample_plan(), {{1, 5}}), "");
  Asr expected = sample_asr(1);
  expected.room = 5;
  expect_same(store_.get(1, AsrDetail::readings), expected);
}

TEST_F(StoredAssembly, PathsThatWereMatchedAgainAreReadButNotAssembledFrom) {
  const Asr online = sample_asr(2);
  Paths paths;
  for (const PathSample& sample : online.path) {
    paths[2].push_back(sample.asr_from_robot * Pose2{0.01, -0.02, 0.003});
  }
  store_.put(sample_assembly(sample_correction(3), sample_plan(), {}, paths), "");
  expect_same(store_.get(2, AsrDetail::readings), online);  // it is open to be updated
  store_.finish();
  Asr matched = online;
  for (std::size_t i = 0; i < paths[2].size(); ++i) matched.path[i].asr_from_robot = paths[2][i];
  {
    const GeoPackageStore store(file_, Mode::read);
    expect_same(store.get(2, AsrDetail::readings), matched);
    expect_same(store.get(1, AsrDetail::readings), sample_asr(1));
  }
  GeoPackageStore again(file_, Mode::update);
  again.put(sample_assembly(sample_correction(3), sample_plan()), "");
  again.finish();
  expect_same(GeoPackageStore(file_, Mode::read).get(2, AsrDetail::readings), online);
}

TEST_F(StoredAssembly, AStoreOfAnEarlierReleaseHasNoMatchedPath) {
  store_.finish();
  SQLite::Database(file_.string(), SQLite::OPEN_READWRITE).exec("DROP TABLE matched_path");
  expect_same(GeoPackageStore(file_, Mode::read).get(2, AsrDetail::readings), sample_asr(2));
  GeoPackageStore store(file_, Mode::update);
  store.put(sample_assembly(sample_correction(3), sample_plan(), {}, {{2, {Pose2{1.0, 2.0, 0.5}}}}),
            "");
  store.finish();
  const Asr asr = GeoPackageStore(file_, Mode::read).get(2, AsrDetail::path);
  EXPECT_EQ(asr.path.front().asr_from_robot, (Pose2{1.0, 2.0, 0.5}));
}

TEST_F(StoredAssembly, AStoreOfAnEarlierReleaseHasNeitherEdgesNorKindsUntilItIsAssembledAgain) {
  store_.put(sample_assembly(sample_correction(3), sample_plan()), "");
  store_.finish();
  {
    SQLite::Database db(file_.string(), SQLite::OPEN_READWRITE);
    for (const char* prefix : {"", "measured_"}) {
      const std::string name = prefix;
      db.exec("DROP TABLE " + name + "edges");
      db.exec("DELETE FROM gpkg_geometry_columns WHERE table_name = '" + name + "edges'");
      db.exec("DELETE FROM gpkg_contents WHERE table_name = '" + name + "edges'");
      for (const char* column :
           {"kind", "leaf_hinge_x", "leaf_hinge_y", "leaf_end_x", "leaf_end_y"}) {
        db.exec("ALTER TABLE " + name + "doors DROP COLUMN " + column);
      }
    }
    db.exec("ALTER TABLE furniture DROP COLUMN kind");
  }
  FloorPlan former = sample_plan();
  former.edges.clear();
  for (PlanDoor& door : former.doors) {
    door.kind = DoorKind::door;
    door.leaf.reset();
  }
  for (PlanFurniture& piece : former.furniture) piece.kind = FurnitureKind::free_standing;
  expect_same(GeoPackageStore(file_, Mode::read).plan(), former);
  GeoPackageStore store(file_, Mode::update);
  store.put(sample_assembly(sample_correction(3), sample_plan()), "");
  store.finish();
  expect_same(GeoPackageStore(file_, Mode::read).plan(), sample_plan());
  SQLite::Database db(file_.string());
  EXPECT_EQ(db.execAndGet("SELECT count(*) FROM gpkg_geometry_columns WHERE table_name LIKE "
                          "'%edges'")
                .getInt(),
            2);
}

TEST_F(StoredAssembly, AFailureKeepsTheFormerOne) {
  store_.put(sample_assembly(sample_correction(3), sample_plan()), "");
  FloorPlan twice = sample_plan();
  twice.rooms.push_back(twice.rooms.front());  // the same id again
  EXPECT_THROW(store_.put(sample_assembly(sample_correction(1), twice), ""), InputError);
  expect_same(store_.plan(), sample_plan());
  expect_same(store_.correction(), sample_correction(3));
}

TEST_F(StoredAssembly, WithoutOneTheErrorSaysHowToGetIt) {
  EXPECT_FALSE(store_.has_assembly());
  try {
    static_cast<void>(store_.plan());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("run 'roomatlas assemble"));
  }
  EXPECT_THROW(static_cast<void>(store_.correction()), InputError);
}

TEST_F(StoredAssembly, ExtentsOfTheLayersAreThoseOfTheGeometry) {
  store_.put(sample_assembly(sample_correction(3), sample_plan()), "");
  store_.finish();
  SQLite::Database db(file_.string());
  SQLite::Statement query(db,
                          "SELECT min_x, min_y, max_x, max_y FROM gpkg_contents "
                          "WHERE table_name = 'rooms'");
  ASSERT_TRUE(query.executeStep());
  EXPECT_EQ(query.getColumn(0).getDouble(), 0.0);
  EXPECT_EQ(query.getColumn(1).getDouble(), 0.0);
  EXPECT_EQ(query.getColumn(2).getDouble(), 21.0);
  EXPECT_EQ(query.getColumn(3).getDouble(), 9.0);
}

}  // namespace
}  // namespace roomatlas
