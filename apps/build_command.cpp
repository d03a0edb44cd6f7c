// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "commands.hpp"
#include "console.hpp"
#include "evaluation_report.hpp"
#include "new_store.hpp"
#include "output_places.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {
namespace {

/// True when an earlier run of `build` left a finished map of this log.
bool is_mapped_already(const Settings& settings, const Path& log, const Path& store_file) {
  if (!std::filesystem::exists(store_file)) return false;
  try {
    const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
    return is_mapped_from(store.metadata(), sha256_of_file(log), settings);
  } catch (const InputError&) {
    return false;  // an interrupted or foreign store is mapped anew
  }
}

void write_summary(const Path& store_file, const std::optional<Evaluation>& evaluation,
                   const Path& out) {
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  const Correction correction = store.correction();
  write_file(out / "summary.json", summary_json(store.metadata(), correction, store.plan(),
                                                graph_of(store, correction), evaluation));
}

/// The highest folder on the way to `folder` that does not exist yet; empty where all do.
Path topmost_missing(const Path& folder) {
  Path missing;
  std::error_code ignored;  // who makes the folder says what is wrong
  for (Path at = std::filesystem::absolute(folder, ignored).lexically_normal();
       !at.empty() && !std::filesystem::exists(at, ignored); at = at.parent_path()) {
    missing = at;
  }
  return missing;
}

}  // namespace

void build(const Settings& settings, const Path& log, const Path& out,
           const std::vector<Path>& truth, const TrajectoryFlags& flags,
           const ExportOptions& options) {
  (void)options.reference();                  // wrong options and
  (void)open_mission(log, settings.mission);  // an unreadable log leaves no folder behind
  const Path new_folder = topmost_missing(out);
  make_folder(out);
  const Path store = out / "building.gpkg";
  require_output_store(store, {log});
  settle_new_store(store);
  if (is_mapped_already(settings, log, store)) {
    spdlog::info("{} holds this mission already; assembling it again", store.string());
    GeoPackageStore(store, GeoPackageStore::Mode::update)
        .put_metadata({{"configuration", settings.as_toml}});  // maps alike: all else may differ
  } else {
    try {
      map(settings, log, store);
    } catch (const NotEnoughError&) {
      if (!new_folder.empty()) std::filesystem::remove_all(new_folder);  // nothing came of it
      throw;
    }
  }
  const std::size_t rooms = assemble(settings, store);
  export_all(settings, store,
             {"svg", "pdf", "png", "geojson", "tum", "dot", "graphml", "g2o", "csv", "nav2"},
             options, out);
  const Evaluation evaluation = evaluation_of(settings, store, truth, flags);
  write_summary(store, evaluation, out);
  write_report(settings, store, evaluation, out / "report.html");
  if (settings.json) {
    fmt::print("{}", to_json(evaluation));
  } else {
    print(evaluation);
  }
  spdlog::info("the plan is {}", (out / "plan.svg").string());
  require_a_room(rooms, store);
}

}  // namespace roomatlas::apps
