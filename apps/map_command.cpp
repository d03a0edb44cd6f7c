// SPDX-License-Identifier: GPL-3.0-or-later
#include <spdlog/spdlog.h>

#include <charconv>
#include <filesystem>

#include "commands.hpp"
#include "console.hpp"
#include "former_store.hpp"
#include "roomatlas/io/formats.hpp"
#include "roomatlas/io/geopackage_store.hpp"
#include "roomatlas/io/room_names.hpp"
#include "roomatlas/io/summary.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {
namespace {

/// A mission whose first event has been looked at: a log that cannot be mapped fails before
/// anything is written.
class PeekedMission : public MissionSource {
 public:
  explicit PeekedMission(MissionSource& mission) : mission_(mission), first_(mission.next()) {}
  std::optional<MissionEvent> next() override {
    return first_ ? std::exchange(first_, std::nullopt) : mission_.next();
  }
  [[nodiscard]] const MissionInfo& info() const override { return mission_.info(); }
  [[nodiscard]] double progress() const override { return mission_.progress(); }

 private:
  MissionSource& mission_;
  std::optional<MissionEvent> first_;
};

void remove_store(const Path& store) {
  for (const char* suffix : {"", "-wal", "-shm"}) {
    std::error_code ignored;
    std::filesystem::remove(store.string() + suffix, ignored);
  }
}

/// The store that a new one replaces stands beside it until something has been mapped, so that a
/// log without walls costs nobody his map.
class FormerStore {
 public:
  explicit FormerStore(const Path& store) : store_(store), aside_(store.string() + ".former") {
    std::error_code none_there;
    std::filesystem::rename(store_, aside_, none_there);
  }
  void bring_back() const {
    remove_store(store_);
    std::error_code none_there;
    std::filesystem::rename(aside_, store_, none_there);
  }
  void remove() const { remove_store(aside_); }

 private:
  Path store_;
  Path aside_;
};

}  // namespace

void map(const Settings& settings, const Path& log, const Path& store_file) {
  const auto mission = open_mission(log, settings.mission);
  PeekedMission peeked(*mission);
  struct NoSink : AsrSink {
    void put(const Asr&) override {}
    void put(const TruePose&) override {}
  };
  if (mission->info().readings == 0 || mission->info().odometry == "none") {
    NoSink nowhere;
    (void)map_mission(peeked, nowhere, settings.map);  // says what is missing
  }

  const std::string sha256 = sha256_of_file(log);
  const std::vector<PlanRoom> carried = rooms_to_carry_over(store_file, sha256);
  const FormerStore former(store_file);
  GeoPackageStore store(store_file, GeoPackageStore::Mode::create);
  if (!carried.empty()) put_former_rooms(store_file, carried);
  MapSummary summary;
  try {
    summary = map_mission(peeked, store, settings.map, console_progress(settings));
  } catch (const NotEnoughError&) {
    former.bring_back();
    throw;
  } catch (const Interrupted&) {
    former.remove();
    throw;
  }
  former.remove();
  const MissionInfo& info = mission->info();
  Metadata metadata = metadata_of(info, sha256, settings);
  if (summary.habits) metadata["odometry_json"] = to_json(*summary.habits);
  store.put_metadata(metadata);
  store.finish();
  show(info.issues, info.issues_not_listed);
  if (summary.intervals_reversed > 0) {
    spdlog::info("{} drives were reported forwards but went backwards", summary.intervals_reversed);
  }
  if (summary.habits) spdlog::info("odometry: {}", describe(*summary.habits));
  spdlog::info("{}: {} readings, {:.0f} m -> {} ASRs in {}", log.filename().string(), info.readings,
               info.path_length_m, summary.asrs, store_file.string());
}

void info(const Settings& settings, const Path& log) {
  const auto mission = open_mission(log, settings.mission);
  while (mission->next()) {
  }
  const MissionInfo& info = mission->info();
  if (settings.json) {
    fmt::print("{}", to_json(info));
    return;
  }
  fmt::print("{}: {} log\n", log.string(), info.format);
  for (const auto& [tag, count] : info.line_counts) fmt::print("  {:<14}{:>8}\n", tag, count);
  for (const auto& [tag, count] : info.ignored_line_counts) {
    fmt::print("  {:<14}{:>8}  (not used)\n", tag, count);
  }
  fmt::print("odometry       {}\n", info.odometry);
  fmt::print("range readings {}\n", info.readings);
  for (const auto& sensor : info.sensors) {
    fmt::print("  {} of {} beams, up to {:.1f} m\n",
               sensor->kind == SensorKind::laser ? "laser" : "sonar ring",
               sensor->robot_from_beam.size(), sensor->max_range_m);
  }
  fmt::print("path           {:.1f} m\n", info.path_length_m);
  if (info.has_times && info.first_timestamp_s && info.last_timestamp_s) {
    fmt::print("duration       {:.1f} s\n", *info.last_timestamp_s - *info.first_timestamp_s);
  }
  fmt::print("robot          {:.2f} m x {:.2f} m\n", info.footprint.length_m,
             info.footprint.width_m);
  if (info.true_poses > 0) fmt::print("true poses     {}\n", info.true_poses);
  if (info.malformed_lines > 0) fmt::print("malformed      {} lines\n", info.malformed_lines);
  show(info.issues, info.issues_not_listed);
}

}  // namespace roomatlas::apps
