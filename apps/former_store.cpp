// SPDX-License-Identifier: GPL-3.0-or-later
#include "former_store.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/merge/carry_over.hpp"

namespace roomatlas::apps {

std::vector<PlanRoom> rooms_to_carry_over(const std::filesystem::path& store_file,
                                          const std::string& mission_sha256) {
  if (!std::filesystem::exists(store_file)) return {};
  try {
    const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
    std::vector<PlanRoom> rooms = store.former_rooms();
    const auto metadata = store.metadata();
    const auto sha256 = metadata.find("mission_sha256");
    if (sha256 == metadata.end() || sha256->second == mission_sha256) return rooms;
    std::vector<std::string> names;
    for (const PlanRoom& room : rooms) {
      if (is_named(room)) names.push_back('"' + room.name + '"');
    }
    if (!names.empty()) {
      spdlog::warn("{} was made from another log: the names of its rooms are lost: {}",
                   store_file.string(), fmt::join(names, ", "));
    }
  } catch (const InputError& error) {
    spdlog::warn("{}; names of rooms that it had are lost", error.what());
  }
  return {};
}

void require_known_version(const Settings& settings, const std::filesystem::path& store) {
  if (settings.force || !std::filesystem::exists(store)) return;
  try {
    const GeoPackageStore known(store, GeoPackageStore::Mode::read);
  } catch (const OtherVersion& error) {
    throw OtherVersion(std::string(error.what()) +
                       ". With --force it is replaced, and names of rooms and corrections by hand "
                       "that it has are lost; or give another name with -o");
  } catch (const InputError&) {  // whoever carries names over tells of one that cannot be read
  }
}

}  // namespace roomatlas::apps
