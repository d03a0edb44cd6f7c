// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <string>
#include <vector>

#include "building_report.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "earlier_results.hpp"
#include "evaluation_report.hpp"
#include "former_store.hpp"
#include "join_stores.hpp"
#include "map_store.hpp"
#include "mission_parts.hpp"
#include "mission_stores.hpp"
#include "new_store.hpp"
#include "output_places.hpp"
#include "plugin_formats.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/maps/read_map.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/merge/carry_over.hpp"
#include "store_metadata.hpp"
#include "truth_files.hpp"

namespace roomatlas::apps {
namespace {

void write_summary(const Path& store_file, const std::optional<Evaluation>& evaluation,
                   const Path& out) {
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  const Correction correction = store.correction();
  write_file(out / "summary.json", summary_json(store.metadata(), correction, store.plan(),
                                                graph_of(store, correction), evaluation));
}

/// What remains once a store is assembled: drawings, summary, report.
/// @param formats of the exports
/// @param gone_on where the missions were mapped on from
/// @returns the names of the files
std::vector<std::string> write_results(const Settings& settings, const Path& store,
                                       const BuildArguments& arguments,
                                       const std::vector<std::string>& formats,
                                       const std::vector<GoneOn>& gone_on = {}) {
  const Path& out = arguments.out;
  std::vector<std::string> files =
      export_all(settings, store, possible_formats(formats, store), arguments.exported, out);
  const Evaluation evaluation =
      evaluation_of(settings, store, arguments.truth, arguments.trajectory);
  write_summary(store, evaluation, out);
  write_report(settings, store, evaluation, out / "report.html");
  files.insert(files.end(), {"summary.json", "report.html", "building.gpkg"});
  report_building(settings, GeoPackageStore(store, GeoPackageStore::Mode::read),
                  {evaluation, !arguments.truth.empty(), out, files, gone_on});
  return files;
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

/// Removes a folder of which nothing came, and those above it that were made for it.
/// @param topmost of those that may be removed; what another run put into one stays
void remove_empty(const Path& folder, const Path& topmost) {
  std::error_code error;
  Path at = std::filesystem::absolute(folder, error).lexically_normal();
  if (!at.has_filename()) at = at.parent_path();  // "OUT/": of the folder, not of what is in it
  while (!topmost.empty() && std::filesystem::remove(at, error) && at != topmost) {
    at = at.parent_path();
  }
}

/// A finished map: a store with its plan and no mission.
void build_from_map(const Settings& settings, const BuildArguments& arguments) {
  const MapCells cells = read_map(arguments.inputs.front(), arguments.resolution_m);
  make_folder(arguments.out);
  const PlaceLock folder_lock(arguments.out);
  const Path store = arguments.out / "building.gpkg";
  const PlaceLock store_lock = lock_new_store(store, {arguments.inputs.front()});
  const std::size_t rooms = map_into_store(settings, arguments.inputs.front(), cells, store);
  tell_earlier_results(arguments.out,
                       write_results(settings, store, arguments,
                                     {"svg", "pdf", "png", "geojson", "graphml", "csv", "nav2"}));
  if (rooms > 0) return;
  throw NotEnoughError(arguments.inputs.front().string() +
                       ": no room was found in this map; all files are written nevertheless. Rooms "
                       "are free cells of 2 m2 and more among occupied ones: are resolution, "
                       "thresholds and negate those of the map?");
}

/// All is written by now.
void require_trust(const Path& store_file) {
  const auto judgement = GeoPackageStore(store_file, GeoPackageStore::Mode::read).judgement();
  if (judgement && judgement->probability >= kTrusted) return;
  throw GateFailed(store_file.string() +
                   ": the map is doubtful, or could not be judged; it is written nevertheless");
}

/// The largest part of a mission whose parts nothing joins is the building. Names and statements
/// that the building in the place has stay, or those of `--edits` hold.
void put_alone(const Settings& settings, const Path& part, const Path& place) {
  const GeoPackageStore base(part, GeoPackageStore::Mode::read);
  const Former former = former_in(place, building_of(base.metadata()));
  const bool is_any_named = std::any_of(former.rooms.begin(), former.rooms.end(), is_named);
  put_copy_in_place(part, place, [&](const Path& copy) {
    if (!is_any_named && former.edits.empty() && settings.edits_file.empty()) return;
    {
      GeoPackageStore store(copy, GeoPackageStore::Mode::update);
      put_said(former, base, store);
    }
    (void)assemble(settings, copy);
  });
}

void require_kept_readings(const Settings& settings, const Path& log) {
  if (settings.map.record.keep_readings) return;
  throw UsageError(log.string() +
                   ": --no-keep-readings: several missions, or the parts of one that was cut at "
                   "kidnappings, are joined by what their readings saw; leave the option away");
}

/// Where the plan of another building than that of the folder is drawn, in that folder.
Path folder_beside(const Path& store) { return Path("beside") / store.stem(); }

/// What is in the folder of results besides those of the building at `place`.
std::vector<std::string> names_of_others(const std::vector<WrittenBuilding>& buildings,
                                         const Path& place) {
  std::vector<std::string> names = {"missions"};
  for (const WrittenBuilding& other : buildings) {
    if (other.store == place) continue;
    names.push_back(folder_beside(other.store).string());
    names.push_back(other.store.filename().string());
  }
  return names;
}

/// Each mission in OUT/missions, what holds together in OUT, and whatever does not beside it.
void build_joined(const Settings& settings, const BuildArguments& arguments,
                  const std::vector<LogPart>& missions) {
  const Path& out = arguments.out;
  make_folder(out / "missions");
  const PlaceLock folder_lock(out);
  const std::vector<Path> named = stores_for(missions, out / "missions");
  std::vector<Path> stores;
  Settings of_one = settings;
  of_one.edits_file.clear();  // they speak of the building that all missions together make
  std::vector<GoneOn> gone_on;
  for (std::size_t i = 0; i < missions.size(); ++i) {
    const auto mapped = map_and_assemble(of_one, missions[i], named[i]);
    if (!mapped) continue;
    stores.push_back(named[i]);
    if (mapped->gone_on) gone_on.push_back(*mapped->gone_on);
  }
  const Path store = out / "building.gpkg";
  const PlaceLock store_lock = lock_new_store(store, arguments.inputs);
  std::vector<WrittenBuilding> buildings = join_into(settings, stores, store);
  if (buildings.empty()) {
    throw NotEnoughError(arguments.inputs.front().string() +
                         ": no part of it between kidnappings is long enough to be mapped");
  }
  if (!is_any_joined(buildings)) {
    if (arguments.inputs.size() > 1 && buildings.size() > 1) require_any_joined(buildings);
    put_alone(settings, buildings.front().store, store);
    buildings.front().store = store;
  }
  const std::vector<std::string> others = names_of_others(buildings, store);
  for (const WrittenBuilding& written : buildings) {
    BuildArguments drawn = arguments;
    if (written.store != store) {
      drawn.out = out / folder_beside(written.store);
      drawn.truth.clear();
      make_folder(drawn.out);
    }
    std::vector<std::string> files = write_results(
        settings, written.store, drawn,
        {"svg", "pdf", "png", "geojson", "tum", "dot", "graphml", "csv", "nav2"}, gone_on);
    files.insert(files.end(), others.begin(), others.end());
    tell_earlier_results(drawn.out, files);
    require_a_room(written.rooms, written.store);
  }
  if (arguments.strict) require_trust(store);
}

void require_missions(const Settings& settings, const std::vector<Path>& logs) {
  for (const Path& log : logs) {
    require_no_map(log);
    (void)open_mission(log, settings.mission);
  }
}

void build_from_log(const Settings& settings, const BuildArguments& arguments) {
  const Path& log = arguments.inputs.front();
  const Path& out = arguments.out;
  if (arguments.resolution_m > 0.0) {
    throw UsageError(log.string() + ": --resolution is for pictures, and this is none");
  }
  (void)open_mission(log, settings.mission);  // an unreadable log leaves no folder behind
  make_folder(out);
  const PlaceLock folder_lock(out);
  const Path store = out / "building.gpkg";
  const PlaceLock store_lock = lock_new_store(store, {log});
  std::vector<GoneOn> gone_on;
  if (!settings.force && is_mapped_already(settings, {log, {}}, store)) {
    spdlog::info("{} holds this mission already; assembling it again", store.string());
    GeoPackageStore(store, GeoPackageStore::Mode::update)
        .put_metadata({{"configuration", settings.as_toml}});  // maps alike: all else may differ
  } else {
    const Mapped mapped = map(settings, log, store);
    if (mapped.gone_on) gone_on.push_back(*mapped.gone_on);
  }
  const std::size_t rooms = assemble(settings, store);
  tell_earlier_results(out, write_results(settings, store, arguments,
                                          {"svg", "pdf", "png", "geojson", "tum", "dot", "graphml",
                                           "g2o", "csv", "nav2"},
                                          gone_on));
  require_a_room(rooms, store);
  if (arguments.strict) require_trust(store);
}

}  // namespace

void build(const Settings& settings, const BuildArguments& arguments) {
  (void)arguments.exported.reference();  // wrong options leave no folder behind
  require_truth_files(arguments.truth);
  require_output_folder(arguments.out, arguments.inputs);
  if (arguments.inputs.size() == 1 && is_map(arguments.inputs.front())) {
    build_from_map(settings, arguments);
    return;
  }
  if (arguments.inputs.size() > 1) require_missions(settings, arguments.inputs);
  const std::vector<LogPart> missions = parts_of(settings, arguments.inputs);
  if (missions.size() > 1) {
    require_kept_readings(settings, arguments.inputs.front());
    build_joined(settings, arguments, missions);
  } else {
    const Path new_folder = topmost_missing(arguments.out);
    try {
      build_from_log(settings, arguments);
    } catch (const NotEnoughError&) {
      remove_empty(arguments.out, new_folder);
      throw;
    }
  }
}

}  // namespace roomatlas::apps
