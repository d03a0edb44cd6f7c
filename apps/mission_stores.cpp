// SPDX-License-Identifier: GPL-3.0-or-later
#include "mission_stores.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <map>
#include <set>

#include "new_store.hpp"
#include "output_places.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/maps/read_map.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "store_metadata.hpp"
#include "usable_store.hpp"

namespace roomatlas::apps {
namespace {

/// Completes an assembled store whose run was stopped before it had finished it.
/// @returns false where it is not assembled
bool finish_if_assembled(const Path& file) {
  {
    const GeoPackageStore store(file, GeoPackageStore::Mode::read);
    if (!store.has_assembly()) return false;
    if (store.is_finished()) return true;
  }
  GeoPackageStore(file, GeoPackageStore::Mode::update).finish();
  return true;
}

/// NAME of "NAME.clf.gz".
std::string name_of(const LogPart& mission) {
  std::string name = mission.log.filename().string();
  name = name.substr(0, name.find('.'));
  return mission.part.is_whole() ? name : fmt::format("{}-part{}", name, mission.part.number);
}

Path numbered_store(const Path& first, int number) {
  const std::string mark = number == 1 ? "" : fmt::format("-{}", number);
  return first.string() + mark + ".gpkg";
}

/// What a store was mapped from, as far as it is; empty where it cannot be read.
std::string mission_in(const Path& store_file) {
  const auto mission = read_if_possible(store_file, [](const GeoPackageStore& store) {
    Metadata known = store.metadata();
    if (const auto unfinished = store.unfinished()) {
      known.insert(unfinished->origin.begin(), unfinished->origin.end());
    }
    const auto sha256 = known.find("mission_sha256");
    return sha256 == known.end() ? std::string() : sha256->second;
  });
  return mission.value_or("");
}

/// By which its store is known; empty where the log cannot be read: who maps it says why.
std::string digest_of(const LogPart& mission) {
  try {
    return sha256_of_part(mission.log, mission.part);
  } catch (const InputError&) {
    return "";
  }
}

constexpr int kLongestGap = 100;  // of numbers whose stores somebody removed

/// @param first path of the stores, without its number and ending
std::vector<Path> stores_of_name(const Path& first) {
  std::vector<Path> there;
  for (int number = 1, missing = 0; missing < kLongestGap; ++number) {
    const Path store = numbered_store(first, number);
    missing = std::filesystem::exists(store) ? 0 : missing + 1;
    if (missing == 0) there.push_back(store);
  }
  return there;
}

/// Files that are a mission's already, behind links: two names may be one file.
using Taken = std::set<Path>;

/// @returns false where it is another mission's
bool take(const Path& store, Taken& taken) { return taken.insert(behind_links(store)).second; }

/// Missions of one name, each with the store that it had, whichever were given then and in whatever
/// order.
/// @param first path of their stores, without its number and ending
void take_their_own(const std::vector<LogPart>& missions, const std::vector<std::size_t>& alike,
                    const Path& first, std::vector<Path>& stores, Taken& taken) {
  const std::vector<Path> there = stores_of_name(first);
  const bool is_first_alone = there.size() == 1 && there.front() == numbered_store(first, 1);
  if (alike.size() == 1 && is_first_alone) {  // no choice: nothing is read
    if (take(there.front(), taken)) stores[alike.front()] = there.front();
    return;
  }
  std::multimap<std::string, Path> held;  // a mission that was given twice has two
  for (const Path& store : there) {
    if (const std::string mission = mission_in(store); !mission.empty()) {
      held.emplace(mission, store);
    }
  }
  for (const std::size_t i : alike) {
    if (held.empty()) return;  // no log is read in vain
    const auto own = held.extract(digest_of(missions[i]));
    if (!own.empty() && take(own.mapped(), taken)) stores[i] = own.mapped();
  }
}

}  // namespace

bool is_mapped_already(const Settings& settings, const LogPart& mission, const Path& store_file) {
  const auto metadata =
      read_if_possible(store_file, [](const GeoPackageStore& store) { return store.metadata(); });
  return metadata && is_mapped_from(*metadata, sha256_of_part(mission.log, mission.part), settings);
}

void require_no_map(const Path& log) {
  if (!is_map(log)) return;
  throw UsageError(log.string() + ": a finished map stands alone: joined are missions");
}

std::optional<Mapped> map_and_assemble(const Settings& settings, const LogPart& mission,
                                       const Path& store) {
  const PlaceLock lock = lock_new_store(store, {mission.log});
  if (!settings.force && is_mapped_already(settings, mission, store) &&
      finish_if_assembled(store)) {
    spdlog::info("{} holds this mission already", store.string());
    return Mapped{};
  }
  try {
    Mapped mapped = map(settings, mission.log, store, mission.part);
    (void)assemble(settings, store);
    return mapped;
  } catch (const NotEnoughError& error) {
    if (mission.part.is_whole()) throw;
    spdlog::warn("{}{}: left out: {}", mission.log.string(), mission.part.suffix(), error.what());
    return std::nullopt;
  }
}

std::vector<Path> stores_for(const std::vector<LogPart>& missions, const Path& folder) {
  std::vector<Path> stores(missions.size());
  std::map<std::string, std::vector<std::size_t>> of_name;
  for (std::size_t i = 0; i < missions.size(); ++i) of_name[name_of(missions[i])].push_back(i);
  Taken taken;
  for (const auto& [name, alike] : of_name) {
    take_their_own(missions, alike, folder / name, stores, taken);
  }
  for (std::size_t i = 0; i < missions.size(); ++i) {
    if (!stores[i].empty()) continue;
    const Path first = folder / name_of(missions[i]);
    for (int number = 1; !take(stores[i] = numbered_store(first, number), taken);) ++number;
  }
  return stores;
}

}  // namespace roomatlas::apps
