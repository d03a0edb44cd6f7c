// SPDX-License-Identifier: GPL-3.0-or-later
#include <spdlog/spdlog.h>

#include "commands.hpp"
#include "console.hpp"
#include "roomatlas/io/geopackage_store.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {

void assemble(const Settings& settings, const Path& store_file) {
  GeoPackageStore store(store_file, GeoPackageStore::Mode::update);
  const Metadata metadata = store.metadata();
  Assembly assembly = roomatlas::assemble(store, footprint_of(metadata), settings.assemble,
                                          console_progress(settings));
  const auto mission = metadata.find("mission_file");
  assembly.plan.title = mission == metadata.end() ? "" : mission->second;
  store.put_assembly(assembly.correction, assembly.plan, assembly.room_of_asr);
  store.finish();
  show(assembly.plan.issues);
  if (!assembly.correction.converged) {
    spdlog::warn("the correction did not converge: {}", assembly.correction.message);
  }
  spdlog::info("{} rooms, {} doors; correction: {} iterations, cost {:.1f} -> {:.1f}",
               assembly.plan.rooms.size(), assembly.plan.doors.size(),
               assembly.correction.iterations, assembly.correction.initial_cost,
               assembly.correction.final_cost);
}

}  // namespace roomatlas::apps
