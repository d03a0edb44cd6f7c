// SPDX-License-Identifier: GPL-3.0-or-later
#include "mission_stores.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <map>

#include "new_store.hpp"
#include "output_places.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/maps/read_map.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {

bool is_mapped_already(const Settings& settings, const Path& log, const Path& store_file) {
  if (!std::filesystem::exists(store_file)) return false;
  try {
    const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
    return is_mapped_from(store.metadata(), sha256_of_file(log), settings);
  } catch (const InputError&) {
    return false;  // an interrupted or foreign store is mapped anew
  }
}

void require_no_map(const Path& log) {
  if (!is_map(log)) return;
  throw UsageError(log.string() + ": a finished map stands alone: joined are missions");
}

void map_and_assemble(const Settings& settings, const Path& log, const Path& store) {
  const PlaceLock lock = lock_new_store(store, {log});
  if (is_mapped_already(settings, log, store) &&
      GeoPackageStore(store, GeoPackageStore::Mode::read).has_assembly()) {
    spdlog::info("{} holds this mission already", store.string());
    return;
  }
  map(settings, log, store);
  (void)assemble(settings, store);
}

std::vector<Path> stores_for(const std::vector<Path>& logs, const Path& folder) {
  std::vector<Path> stores;
  std::map<std::string, int> named;
  for (const Path& log : logs) {
    std::string name = log.filename().string();
    name = name.substr(0, name.find('.'));
    const int number = ++named[name];
    if (number > 1) name += fmt::format("-{}", number);
    stores.push_back(folder / (name + ".gpkg"));
  }
  return stores;
}

}  // namespace roomatlas::apps
