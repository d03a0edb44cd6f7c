// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "building_report.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "former_store.hpp"
#include "going_on.hpp"
#include "log_as_it_was.hpp"
#include "log_report.hpp"
#include "new_store.hpp"
#include "open_log.hpp"
#include "output_places.hpp"
#include "printable.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/pipeline/map_mission.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {
namespace {

/// A mission whose first event has been looked at: a log that cannot be mapped fails before
/// anything is written.
class PeekedMission : public MissionSource {
 public:
  PeekedMission(MissionSource& mission, const LogAsItWas& log)
      : mission_(mission), log_(log), first_(mission.next()) {}
  std::optional<MissionEvent> next() override {
    auto event = first_ ? std::exchange(first_, std::nullopt) : mission_.next();
    if (!event) log_.require_unchanged();
    return event;
  }
  [[nodiscard]] const MissionInfo& info() const override { return mission_.info(); }
  [[nodiscard]] double progress() const override { return mission_.progress(); }

 private:
  MissionSource& mission_;
  const LogAsItWas& log_;
  std::optional<MissionEvent> first_;
};

/// What a mapped mission leaves to tell.
struct Recorded {
  MapSummary summary;
  MissionInfo info;
};

/// The whole mission into a store, which is finished and closed then.
/// @param from where a run was stopped whose rooms are in the store
Recorded record(const Settings& settings, MissionSource& mission, const std::string& sha256,
                const Former& former, const Path& store_file,
                const std::optional<MapCheckpoint>& from) {
  GeoPackageStore store(store_file,
                        from ? GeoPackageStore::Mode::update : GeoPackageStore::Mode::create);
  if (from) {
    store.go_back_to_checkpoint();
  } else {
    store.put_origin(origin_of(sha256, settings));
  }
  if (!former.rooms.empty()) store.put_former_rooms(former.rooms);
  if (!former.edits.empty()) store.put_metadata(former.edits);
  Recorded recorded;
  recorded.summary = map_mission(mission, store, settings.map, from, console_progress(settings));
  recorded.info = mission.info();
  Metadata metadata = metadata_of(recorded.info, sha256, settings);
  if (recorded.summary.habits) metadata["odometry_json"] = to_json(*recorded.summary.habits);
  store.put_metadata(metadata);
  store.finish();
  return recorded;
}

/// The same in the place of what is there, which stays as it is unless all goes well.
Recorded record_in_place(const Settings& settings, MissionSource& mission,
                         const std::string& sha256, const Path& store_file,
                         const std::optional<UnfinishedStore>& unfinished) {
  const Former former = former_in(store_file, sha256);
  const NewStore store = unfinished ? NewStore(store_file, unfinished->file) : NewStore(store_file);
  const auto from =
      unfinished ? std::optional<MapCheckpoint>(unfinished->checkpoint) : std::nullopt;
  try {
    Recorded recorded = record(settings, mission, sha256, former, store.file(), from);
    store.put_in_place();
    return recorded;
  } catch (const Interrupted& stop) {
    const Path kept = store.keep_unfinished();
    throw Interrupted(fmt::format(
        "{}: the rooms so far are in {}{}; run the same command to go on", stop.what(),
        kept.string(),
        kept == behind_links(store_file) ? "" : ", and " + store_file.string() + " is as it was"));
  } catch (const NotEnoughError&) {
    store.remove();
    throw;
  } catch (const ChangedLog&) {
    store.remove();
    throw;
  } catch (...) {
    store.give_up();
    throw;
  }
}

/// Completes a store that a run had filled with the whole mission when it was stopped.
/// @returns false where there is none, or it was assembled since
bool finish_mapped(const Settings& settings, const std::string& sha256, const Path& store_file) {
  if (settings.force || !std::filesystem::exists(store_file)) return false;
  try {
    const GeoPackageStore found(store_file, GeoPackageStore::Mode::read);
    if (found.has_assembly() || !is_mapped_from(found.metadata(), sha256, settings)) return false;
  } catch (const InputError&) {
    return false;  // a foreign store is mapped anew
  }
  GeoPackageStore store(store_file, GeoPackageStore::Mode::update);
  store.put_metadata({{"configuration", settings.as_toml}});  // maps alike: all else may differ
  store.finish();
  spdlog::info("{} holds this mission already", store_file.string());
  return true;
}

/// Whether a mission's directions of drive are decided again when it is assembled.
bool is_corrected_as_a_whole(const MissionInfo& info, const Settings& settings) {
  return settings.assemble.correct_sonars && settings.map.record.keep_readings &&
         std::all_of(info.sensors.begin(), info.sensors.end(),
                     [](const auto& sensor) { return sensor->kind == SensorKind::sonar; });
}

}  // namespace

Mapped map(const Settings& settings, const Path& log, const Path& store_file,
           const MissionPart& part) {
  require_output_store(store_file, {log});
  require_known_version(settings, store_file);
  settle_new_store(store_file);
  const LogAsItWas as_it_was(log);
  const auto opened = open_log(log, settings.mission);
  const std::string sha256 = sha256_of_part(log, part);
  if (finish_mapped(settings, sha256, store_file)) return {};
  PartOfMission cut(*opened, part);
  const MissionSource* mission = opened.get();  // of the whole log: what it lacks is told of it
  PeekedMission peeked(cut, as_it_was);
  struct NoSink : AsrSink {
    void put(const Asr&) override {}
    void put(const TruePose&) override {}
  };
  if (mission->info().readings == 0 || mission->info().odometry == "none") {
    while (peeked.next()) {
    }
    require_lines_that_could_be_read(mission->info());  // says what is wrong, else
    NoSink nowhere;
    (void)map_mission(peeked, nowhere, settings.map);  // says what is missing
  }

  const auto unfinished =
      settings.force ? std::nullopt : find_unfinished(settings, sha256, store_file);
  Mapped mapped;
  if (unfinished) {
    mapped.gone_on = gone_on_with(*unfinished, log, part);
    spdlog::info("{}: {}", unfinished->file.string(), to_string(*mapped.gone_on));
  }
  const auto [summary, info] = record_in_place(settings, peeked, sha256, store_file, unfinished);
  if (info.recording) spdlog::info("{}: {}", log.filename().string(), info.recording->choice);
  show(info.issues, info.issues_not_listed);
  // of a mission that is corrected as a whole, `assemble` tells the count that holds
  if (summary.drives_reversed > 0 && !is_corrected_as_a_whole(info, settings)) {
    spdlog::info("{} reported forwards went backwards", counted(summary.drives_reversed, "drive"));
  }
  if (summary.habits) spdlog::info("odometry: {}", describe(*summary.habits));
  spdlog::info("{}: {}, {:.0f} m -> {} in {}", log.filename().string() + part.suffix(),
               counted(info.readings, "reading"), info.path_length_m, counted(summary.asrs, "ASR"),
               store_file.string());
  return mapped;
}

void map_and_tell(const Settings& settings, const Path& log, const Path& store_file) {
  const Mapped mapped = map(settings, log, store_file);
  if (settings.json) tell_mapped(mapped, store_file);
}

void info(const Settings& settings, const Path& log) {
  const auto mission = open_log(log, settings.mission);
  try {
    while (mission->next()) {
    }
  } catch (const std::runtime_error&) {
    if (const auto& recording = mission->info().recording) print(*recording);  // may tell why
    throw;
  }
  const MissionInfo& info = mission->info();
  if (settings.json) {
    fmt::print("{}", to_json(info));
    return;
  }
  say("{}: {}{}\n", log.string(), info.format, info.recording ? "" : " log");
  if (info.recording) print(*info.recording);
  for (const auto& [tag, count] : info.line_counts) {
    if (!info.recording) say("  {:<14}{:>8}\n", tag, count);
  }
  for (const auto& [tag, count] : info.ignored_line_counts) {
    say("  {:<14}{:>8}  (not used)\n", tag, count);
  }
  say("odometry       {}\n", info.odometry);
  say("range readings {}\n", info.readings);
  for (const auto& sensor : info.sensors) {
    say("  {} of {}, up to {:.1f} m\n", sensor->kind == SensorKind::laser ? "laser" : "sonar ring",
        counted(sensor->robot_from_beam.size(), "beam"), sensor->max_range_m);
  }
  say("path           {:.1f} m\n", info.path_length_m);
  if (info.has_times && info.first_timestamp_s && info.last_timestamp_s) {
    say("duration       {:.1f} s\n", *info.last_timestamp_s - *info.first_timestamp_s);
  }
  say("robot          {:.2f} m x {:.2f} m\n", info.footprint.length_m, info.footprint.width_m);
  if (info.true_poses > 0) say("true poses     {}\n", info.true_poses);
  if (info.malformed_lines > 0) {
    say("malformed      {}\n", counted(info.malformed_lines, "line"));
  }
  show(info.issues, info.issues_not_listed);
}

}  // namespace roomatlas::apps
