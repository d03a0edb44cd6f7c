// SPDX-License-Identifier: GPL-3.0-or-later
#include "join_stores.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <set>

#include "building_report.hpp"
#include "console.hpp"
#include "former_store.hpp"
#include "new_store.hpp"
#include "output_places.hpp"
#include "plan_report.hpp"
#include "roomatlas/asr/joined_source.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "store_edits.hpp"
#include "store_metadata.hpp"
#include "usable_store.hpp"

namespace roomatlas::apps {
namespace {

using Stores = std::vector<std::unique_ptr<GeoPackageStore>>;

std::string title_of(const std::vector<MemberMission>& members) {
  constexpr std::size_t kNamed = 3;  // more do not fit a title
  if (members.size() > kNamed) return counted(members.size(), "mission");
  std::vector<std::string> names;
  names.reserve(members.size());
  for (const MemberMission& member : members) names.push_back(member.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Of all missions together; robot and date are those of the base.
Metadata metadata_of(const JoinedBuilding& building, const Stores& stores,
                     const Settings& settings) {
  Metadata metadata = stores[building.missions.front()]->metadata();
  double path_m = 0.0;
  std::set<std::string> missions;
  for (const std::size_t i : building.missions) {
    const Metadata of_one = stores[i]->metadata();
    path_m += path_length_of(of_one);
    missions.merge(missions_of(of_one));
  }
  Metadata joined = {{"tool_version", ROOMATLAS_VERSION},
                     {"configuration", settings.as_toml},
                     {"mission_file", title_of(building.members)},
                     {"mission_path_length_m", fmt::format("{}", path_m)},
                     {"building", building_of(metadata)},
                     {kMissionsKey, fmt::format("{}", fmt::join(missions, " "))}};
  for (const char* key : {"robot_length_m", "robot_width_m", "mission_first_timestamp_s"}) {
    if (metadata.contains(key)) joined[key] = metadata[key];
  }
  return joined;
}

std::size_t write_building(const Settings& settings, const JoinedBuilding& building,
                           const Stores& stores, const Path& place) {
  std::vector<const AsrSource*> sources;
  for (const std::size_t i : building.missions) sources.push_back(stores[i].get());
  const JoinedSource source(sources);
  settle_new_store(place);
  const GeoPackageStore& base = *stores[building.missions.front()];
  const Former former = former_in(place, building_of(base.metadata()));
  const NewStore made(place);
  try {
    GeoPackageStore store(made.file(), GeoPackageStore::Mode::create);
    for (const TruePose& pose : source.truth()) store.put(pose);
    for (const AsrId id : source.ids()) store.put(source.get(id, AsrDetail::readings));
    store.put_members(building.members);
    store.put_metadata(metadata_of(building, stores, settings));
    put_said(former, base, store);
    Settings used = settings;
    used.assemble.edits = edits_for(settings, store);
    const Assembly assembly =
        assemble_joined(store, building, used, settings.as_toml, console_progress(settings));
    keep_edits(used.assemble.edits, store);
    store.finish();
    made.put_in_place();
    show(assembly.plan.issues);
    show(assembly.seen_last, place);
    return assembly.plan.rooms.size();
  } catch (...) {
    made.give_up();
    throw;
  }
}

void tell(const JoinedBuilding& building, const Path& store) {
  for (const MemberMission& member : building.members) {
    if (member.is_base) {
      spdlog::info("{}: {} is where the building's frame is from", store.string(), member.name);
      continue;
    }
    spdlog::info(
        "{}: {} joined: {} of {} of its path fit, {:.0f} % of what can be compared "
        "agrees; score {:.0f}, the next place {:.0f}",
        store.string(), member.name, member.pieces_fitting, counted(member.pieces, "piece"),
        100.0 * member.agreement, member.score, member.runner_up_score);
  }
}

void tell_alone(const JoinedBuilding& building) {
  const MemberMission& member = building.members.front();
  const bool is_ambiguous = building.verdict == PlaceVerdict::ambiguous;
  spdlog::warn("{}: not joined: {}", member.name,
               is_ambiguous
                   ? "two places fit nearly as well; it stays a building of its own until a "
                     "mission shows more of what tells them apart"
                   : "nothing holds it to the others; it stays a building of its own");
  if (member.pieces == 0) return;
  spdlog::info(
      "{}: at its likeliest place {} of {} of its path fit, {:.0f} % of what can be compared "
      "agrees; score {:.0f}, the next place {:.0f}",
      member.name, member.pieces_fitting, counted(member.pieces, "piece"), 100.0 * member.agreement,
      member.score, member.runner_up_score);
}

Path numbered(const Path& place, std::size_t number) {
  if (number == 1) return place;
  Path other = place;
  other.replace_filename(
      fmt::format("{}.{}{}", place.stem().string(), number, place.extension().string()));
  return other;
}

}  // namespace

StoresToJoin::StoresToJoin(std::vector<Path> stores) : files_(std::move(stores)) {
  for (const Path& file : files_) {
    missions_.push_back(std::make_unique<GeoPackageStore>(file, GeoPackageStore::Mode::read));
    require_assembled(*missions_.back());
    require_readings(*missions_.back(), "missions are joined by what their readings saw");
  }
  leave_out_repeated();
}

/// A mission that is there twice would speak for itself. The larger building of two stays.
void StoresToJoin::leave_out_repeated() {
  std::vector<std::set<std::string>> held;
  held.reserve(missions_.size());
  for (const auto& mission : missions_) held.push_back(missions_of(mission->metadata()));
  std::vector<std::size_t> order(held.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return held[a].size() > held[b].size(); });
  std::map<std::string, std::size_t> holder;
  for (const std::size_t i : order) {
    std::vector<std::size_t> others;
    for (const std::string& one : held[i]) {
      const auto [known, is_new] = holder.emplace(one, i);
      if (!is_new) others.push_back(known->second);
    }
    if (others.empty()) continue;
    const Path& other = files_[others.front()];
    if (others.size() < held[i].size()) {
      throw UsageError(
          fmt::format("{} and {} hold one mission both: join the stores of the missions, each once",
                      other.string(), files_[i].string()));
    }
    left_out_.push_back(
        fmt::format("{}: left out: {} holds the same mission", files_[i].string(), other.string()));
    missions_[i].reset();
    files_[i].clear();
  }
  std::erase(missions_, nullptr);
  std::erase(files_, Path());
}

std::vector<JoinedBuilding> StoresToJoin::joined(const Settings& settings, const Progress& progress,
                                                 const Workers& workers,
                                                 std::optional<std::size_t> base) const {
  std::vector<const AssemblyStore*> opened;
  opened.reserve(missions_.size());
  for (const auto& mission : missions_) opened.push_back(mission.get());
  return join_stores(opened, settings, progress, workers, base);
}

std::optional<std::size_t> StoresToJoin::base_at(const Path& place) const {
  const std::string building = named_building_in(place);
  for (std::size_t i = 0; i < missions_.size() && !building.empty(); ++i) {
    if (building_of(missions_[i]->metadata()) == building) return i;
  }
  return std::nullopt;
}

std::vector<WrittenBuilding> StoresToJoin::write(const Settings& settings,
                                                 std::vector<JoinedBuilding> buildings,
                                                 const Path& place) const {
  for (const std::string& left_out : left_out_) spdlog::warn("{}", left_out);
  std::vector<WrittenBuilding> written;
  std::size_t number = 0;
  for (JoinedBuilding& building : buildings) {
    if (building.missions.size() < 2) {
      tell_alone(building);
      const std::size_t alone = building.missions.front();
      const std::size_t rooms = missions_[alone]->plan().rooms.size();
      written.push_back({std::move(building), files_[alone], rooms});
      continue;
    }
    const Path store = numbered(place, ++number);
    std::optional<PlaceLock> lock;  // that of the first is held since before the missions were read
    if (number > 1) lock.emplace(lock_new_store(store, files_));
    tell(building, store);
    for (const std::size_t i : building.answered_otherwise) {
      spdlog::warn(
          "{}: its readings have two answers, and the others bear out the one that is not drawn "
          "there; it was joined so: `roomatlas assemble {} --alternative {}` draws it alone",
          files_[i].string(), files_[i].string(),
          answers_in(missions_[i]->metadata()).drawn == 1 ? 2 : 1);
    }
    const std::size_t rooms = write_building(settings, building, missions_, store);
    spdlog::info("{}: {} of {}", store.string(), counted(rooms, "room"),
                 counted(building.members.size(), "mission"));
    written.push_back({std::move(building), store, rooms});
  }
  return written;
}

bool is_any_joined(const std::vector<WrittenBuilding>& buildings) {
  return std::any_of(buildings.begin(), buildings.end(),
                     [](const WrittenBuilding& one) { return one.building.missions.size() > 1; });
}

void require_any_joined(const std::vector<WrittenBuilding>& buildings) {
  if (is_any_joined(buildings)) return;
  if (buildings.size() < 2) {
    throw NotEnoughError("nothing is written: joined are two missions and more");
  }
  throw NotEnoughError(
      "nothing holds any two of these missions together: they share no rooms, or what they share "
      "looks alike in several places. Each has its own plan; a mission that drives from the one's "
      "rooms to the other's would join them");
}

std::vector<WrittenBuilding> join_into(const Settings& settings, const std::vector<Path>& stores,
                                       const Path& place) {
  require_output_store(place, stores);
  const StoresToJoin missions(stores);
  return missions.write(
      settings,
      missions.joined(settings, console_progress(settings), settings.jobs, missions.base_at(place)),
      place);
}

void join(const Settings& settings, const std::vector<Path>& stores, const Path& out) {
  const PlaceLock lock = lock_new_store(out, stores);
  const std::vector<WrittenBuilding> written = join_into(settings, stores, out);
  require_any_joined(written);
  if (settings.json) tell_joined(written);
}

}  // namespace roomatlas::apps
