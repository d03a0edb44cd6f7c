// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "former_store.hpp"
#include "log_as_it_was.hpp"
#include "open_log.hpp"
#include "output_places.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/logs/mission_writer.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/maps/read_map.hpp"
#include "roomatlas/io/maps/read_world.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/trajectories/tum.hpp"
#include "roomatlas/pipeline/assemble_map.hpp"
#include "roomatlas/pipeline/assemble_store.hpp"
#include "roomatlas/pipeline/evaluate_store.hpp"
#include "roomatlas/pipeline/map_mission.hpp"
#include "roomatlas/simulate/explore.hpp"
#include "roomatlas/simulate/tour.hpp"
#include "roomatlas/simulate/world.hpp"
#include "settings.hpp"
#include "store_edits.hpp"
#include "store_metadata.hpp"
#include "truth_files.hpp"

namespace roomatlas::python {
namespace {

using apps::Settings;

/// @throws UsageError for a name that no parameter has, and for a value out of its range
Settings settings_of(const std::string& parameters) {
  std::vector<std::string> of_the_program;  // how it works: quiet, json
  apps::FromConfiguration read = apps::with_configuration(
      apps::default_settings(), parameters, [&](const std::string& name, apps::Stage stage) {
        if (stage == apps::Stage::run) of_the_program.push_back(name);
        return stage != apps::Stage::run;
      });
  read.unknown.insert(read.unknown.end(), of_the_program.begin(), of_the_program.end());
  if (read.unknown.empty()) return std::move(read.settings);
  throw UsageError(fmt::format(
      "no such parameter: {}; `roomatlas config --print` shows all, with - for each _ of Python",
      fmt::join(read.unknown, ", ")));
}

void map_log(const Path& log, GeoPackageStore& store, const std::string& sha256,
             const Settings& settings, const Progress& progress) {
  const apps::LogAsItWas as_it_was(log);
  const auto mission = apps::open_log(log, settings.mission);
  const MapSummary summary = map_mission(*mission, store, settings.map, progress);
  as_it_was.require_unchanged();
  apps::Metadata metadata = apps::metadata_of(mission->info(), sha256, settings);
  if (summary.habits) metadata["odometry_json"] = to_json(*summary.habits);
  store.put_metadata(metadata);
}

/// A store without a mission.
void put_map(const Path& file, const MapCells& cells, GeoPackageStore& store,
             const std::string& sha256, const Settings& settings, const Progress& progress) {
  MissionInfo info;  // a map says nothing of the drive behind it
  info.file = file.filename().string();
  apps::Metadata metadata = apps::metadata_of(info, sha256, settings);
  metadata.erase("mission_json");
  store.put_metadata({*metadata.find("mission_file")});
  (void)assemble_map(store, cells, settings, settings.as_toml, progress);
  store.put_metadata(metadata);  // a store with the map's checksum is whole
}

}  // namespace

void build(const Path& input, const Path& store_file, const Path& former, double resolution_m,
           const std::string& parameters, int jobs, const Progress& progress) {
  Settings settings = settings_of(parameters);
  if (jobs < 0) throw UsageError("jobs: expected 0 (one thread a core) or more");
  settings.jobs = jobs;
  const bool from_map = is_map(input);
  if (!from_map && resolution_m > 0.0) {
    throw UsageError(input.string() + ": resolution_m is for pictures, and this is none");
  }
  const auto cells = from_map ? std::optional(read_map(input, resolution_m)) : std::nullopt;
  if (!from_map) (void)open_mission(input, settings.mission);  // fails before anything is written
  const std::string sha256 = sha256_of_file(input);
  const apps::Former kept = apps::former_in(former, sha256);
  GeoPackageStore store(store_file, GeoPackageStore::Mode::create);
  if (!kept.rooms.empty()) store.put_former_rooms(kept.rooms);
  store.put_metadata(kept.edits);
  settings.assemble.edits = apps::stored_edits(store);
  if (from_map) {
    put_map(input, *cells, store, sha256, settings, progress);
  } else {
    map_log(input, store, sha256, settings, progress);
    (void)assemble_store(store, settings, settings.as_toml, progress);
  }
  store.finish();
}

Building read_building(const Path& store_file) {
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  if (!store.has_assembly()) {
    throw NotEnoughError(store_file.string() +
                         ": not assembled yet: run `roomatlas assemble` on it first");
  }
  PlacedMission placed = place(store, store.correction());
  Building building{{store.plan(), {}},
                    std::move(placed.odometry),
                    std::move(placed.corrected),
                    store.judgement()};
  const apps::Metadata metadata = store.metadata();
  PlanAnnotations& annotations = building.drawn.annotations;
  annotations.mission = building.drawn.plan.title;
  annotations.date = apps::date_of(metadata);
  annotations.path_length_m = apps::path_length_of(metadata);
  for (const StampedPose& pose : building.corrected) {
    annotations.trajectory.push_back(pose.pose.position());
  }
  for (const PlanDoor& door : building.drawn.plan.doors) {
    if (door.room_a && door.room_b) annotations.room_graph.emplace_back(*door.room_a, *door.room_b);
  }
  if (building.judgement) {
    for (const RoomJudgement& room : building.judgement->rooms) {
      if (room.probability < kTrusted) annotations.doubtful_rooms.insert(room.room);
    }
  }
  return building;
}

DrawnPlan segment(const MapCells& map, const std::string& parameters, const Progress& progress) {
  return {assemble_map(map, settings_of(parameters), progress).plan, {}};
}

DrawnPlan segment(const Path& map, double resolution_m, const std::string& parameters,
                  const Progress& progress) {
  DrawnPlan drawn = segment(read_map(map, resolution_m), parameters, progress);
  drawn.annotations.mission = map.filename().string();
  return drawn;
}

std::string evaluate(const Path& store_file, const std::vector<Path>& truth,
                     const std::string& parameters) {
  const Settings settings = settings_of(parameters);
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  const Evaluation evaluation = evaluate_store(store, apps::read_truth(truth, settings));
  return to_json(evaluation, store.judgement());
}

std::size_t simulate(const SimulationTask& task, const std::string& parameters,
                     const Progress& progress) {
  const Settings settings = settings_of(parameters);
  const FloorPlan world = read_world(task.world, {});
  require_sound(world);
  ExploreOptions explored = settings.explore;
  explored.world_from_start = default_start(world, settings.simulation.footprint);
  Drive drive = task.drive;
  if (task.tour) {
    drive = driven_within(
        tour(world, explored.world_from_start->position(), {settings.simulation.footprint}),
        explored.max_time_s, settings.simulation);
  }
  apps::make_folder(task.out);
  const auto log = create_mission(task.out / ("mission." + task.format),
                                  range_sensor(settings.simulation), settings.simulation.footprint);
  Trajectory truth;
  const auto write = [&](const SimulatedStep& step) {
    log->write(step);
    truth.push_back({step.truth.timestamp_s, step.truth.world_from_robot});
    report(progress, "simulating", -1.0);
  };
  if (drive.empty()) {
    (void)explore(world, settings.simulation, explored, write);
  } else {
    roomatlas::simulate(world, drive, settings.simulation, write);
  }
  log->finish();
  write_tum(task.out / "truth.tum", truth);
  write_file(task.out / "truth.geojson", to_geojson(world));
  return truth.size();
}

}  // namespace roomatlas::python
