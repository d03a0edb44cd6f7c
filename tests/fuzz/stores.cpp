// SPDX-License-Identifier: GPL-3.0-or-later
// Stores, by their bytes; tests/apps/damaged_store_test.cpp damages them through SQL.
#include <SQLiteCpp/SQLiteCpp.h>

#include "io/store/assembly_samples.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "target.hpp"

namespace roomatlas::fuzz {
namespace {

/// With small pages, so that there is less of it.
std::string store_of(int asrs) {
  return written("building.gpkg", [&](const Path& file) {
    GeoPackageStore store(file, GeoPackageStore::Mode::create);
    for (AsrId id = 1; id <= asrs; ++id) store.put(sample_asr(id, 2));
    store.put(TruePose{1.5, {1, 2, 3}});
    store.put_metadata({{"configuration", "cell=0.1\n"}, {"mission_file", "mission.clf"}});
    store.put(sample_assembly(sample_correction(asrs), sample_plan(), {{1, 1}}), "cell=0.1\n");
    store.finish();
    SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
    database.exec("PRAGMA page_size = 512");
    database.exec("VACUUM");
  });
}

void read_store(const Path& file, const std::string&) {
  for (const auto mode : {GeoPackageStore::Mode::read, GeoPackageStore::Mode::read_as_mapped}) {
    const GeoPackageStore store(file, mode);
    for (const AsrId id : store.ids()) (void)store.get(id, AsrDetail::readings);
    (void)store.truth();
    (void)store.metadata();
    (void)store.mission();
    (void)store.members();
    (void)store.former_rooms();
    if (!store.has_assembly()) continue;
    (void)to_geojson(store.plan());
    (void)store.measured_plan();
    (void)store.correction();
    (void)store.judgement();
    (void)store.closures();
  }
}

}  // namespace

std::vector<Target> store_targets() {
  return {{"stores", "building.gpkg",
           [] {
             return std::vector<std::string>{store_of(3), store_of(1)};
           },
           read_store}};
}

}  // namespace roomatlas::fuzz
