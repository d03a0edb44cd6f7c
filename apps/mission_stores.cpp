// SPDX-License-Identifier: GPL-3.0-or-later
#include "mission_stores.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <set>

#include "new_store.hpp"
#include "output_places.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/maps/read_map.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "store_metadata.hpp"

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

}  // namespace

bool is_mapped_already(const Settings& settings, const LogPart& mission, const Path& store_file) {
  if (!std::filesystem::exists(store_file)) return false;
  try {
    const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
    return is_mapped_from(store.metadata(), sha256_of_part(mission.log, mission.part), settings);
  } catch (const InputError&) {
    return false;  // an interrupted or foreign store is mapped anew
  }
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
  std::vector<Path> stores;
  std::set<std::string> taken;
  for (const LogPart& mission : missions) {
    std::string name = mission.log.filename().string();
    name = name.substr(0, name.find('.'));
    if (!mission.part.is_whole()) name += fmt::format("-part{}", mission.part.number);
    const std::string first = name;
    for (int number = 2; !taken.insert(name).second; ++number) {
      name = fmt::format("{}-{}", first, number);
    }
    stores.push_back(folder / (name + ".gpkg"));
  }
  return stores;
}

}  // namespace roomatlas::apps
