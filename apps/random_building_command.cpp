// SPDX-License-Identifier: GPL-3.0-or-later
#include <spdlog/spdlog.h>

#include "building_report.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "new_store.hpp"
#include "output_places.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/trajectories/tum.hpp"
#include "roomatlas/simulate/random_building.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {
namespace {

constexpr std::int64_t kTruthRooms = 100000;  // the truth of more is not held in memory

RandomBuildingOptions options_of(const Settings& settings, std::int64_t rooms) {
  RandomBuildingOptions options;
  options.rooms = rooms;
  options.seed = settings.simulation.seed;
  options.odometry = settings.simulation.odometry;
  options.max_piece_path_m = settings.map.record.max_piece_path_m;
  options.speed_m_per_s = settings.simulation.speed_m_per_s;
  options.start_timestamp_s = settings.simulation.start_timestamp_s;
  return options;
}

/// Passes ASRs on, keeps the true poses, and says how far it is.
class WatchedSink : public AsrSink {
 public:
  WatchedSink(AsrSink& sink, const Settings& settings, std::int64_t rooms)
      : sink_(sink), progress_(console_progress(settings)), rooms_(rooms) {}
  void put(const Asr& asr) override { sink_.put(asr); }
  void put(const TruePose& truth) override {
    if (rooms_ <= kTruthRooms) true_poses.push_back({truth.timestamp_s, truth.world_from_robot});
    sink_.put(truth);
  }
  void at_room(RoomId room) {
    if (!progress_("simulate", static_cast<double>(room) / static_cast<double>(rooms_))) {
      throw Interrupted("interrupted while simulating: no store was written");
    }
  }

  Trajectory true_poses;

 private:
  AsrSink& sink_;
  Progress progress_;
  std::int64_t rooms_;
};

MissionInfo info_of(const RandomBuildingOptions& options, const RandomBuildingSummary& summary) {
  MissionInfo info;
  info.file = "random building of " + std::to_string(options.rooms) + " rooms";
  info.format = "random building";
  info.odometry = "simulated";
  info.true_poses = summary.path_samples;
  info.path_length_m = summary.path_length_m;
  info.first_timestamp_s = options.start_timestamp_s;
  info.last_timestamp_s = options.start_timestamp_s + summary.path_length_m / options.speed_m_per_s;
  return info;
}

struct Made {
  RandomBuildingSummary summary;
  Trajectory true_poses;
};

Made write_store(const Settings& settings, const RandomBuildingOptions& options, std::int64_t rooms,
                 const Path& place) {
  const NewStore made(place);
  try {
    GeoPackageStore store(made.file(), GeoPackageStore::Mode::create);
    WatchedSink sink(store, settings, rooms);
    const RandomBuildingSummary summary =
        random_building(options, sink, [&](const TrueVisit& visit) { sink.at_room(visit.room); });
    store.put_metadata(metadata_of(info_of(options, summary), "", settings));
    store.finish();
    made.put_in_place();
    return {summary, std::move(sink.true_poses)};
  } catch (...) {
    made.give_up();
    throw;
  }
}

}  // namespace

void simulate_rooms(const Settings& settings, std::int64_t rooms, const Path& out) {
  const RandomBuildingOptions options = options_of(settings, rooms);
  if (rooms < 1) throw UsageError("--random-rooms: expected 1 or more");
  make_folder(out);
  const PlaceLock lock(out);
  const Path place = out / "building.gpkg";
  const PlaceLock store_lock = lock_new_store(place, {});
  const Made made = write_store(settings, options, rooms, place);
  const RandomBuildingSummary& summary = made.summary;
  if (rooms <= kTruthRooms) {
    write_tum(out / "truth.tum", made.true_poses);
    write_file(out / "truth.geojson", to_geojson(random_building_plan(options)));
  } else {
    spdlog::info("no truth.tum and no truth.geojson above {} rooms; true poses are in the store",
                 kTruthRooms);
  }
  spdlog::info("{}, {}, {:.0f} m driven -> {} in {}", counted(summary.rooms, "room"),
               counted(summary.doors, "door"), summary.path_length_m, counted(summary.asrs, "ASR"),
               (out / "building.gpkg").string());
  if (!settings.json) return;
  std::vector<std::string> files = {"building.gpkg"};
  if (rooms <= kTruthRooms) files.insert(files.end(), {"truth.tum", "truth.geojson"});
  tell_files(settings, out, files);
}

}  // namespace roomatlas::apps
