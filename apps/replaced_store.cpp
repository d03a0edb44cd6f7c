// SPDX-License-Identifier: GPL-3.0-or-later
#include "replaced_store.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <string>
#include <vector>

#include "printable.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/store/store_use.hpp"
#include "roomatlas/merge/carry_over.hpp"
#include "store_edits.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {
namespace {

namespace fs = std::filesystem;

/// Of a file into which nothing was mapped there is none; of one that was made up nobody knows.
bool is_of_another_building(const GeoPackageStore& former, const GeoPackageStore& now) {
  const Metadata metadata = former.metadata();
  const bool is_known = metadata.contains("building") || metadata.contains("mission_sha256");
  const std::string building = building_of(metadata);
  return is_known && (building.empty() || building != building_of(now.metadata()));
}

/// What people said of the building in it.
std::vector<std::string> said_in(const GeoPackageStore& store) {
  std::vector<std::string> said;
  for (const PlanRoom& room : store.former_rooms()) {
    if (is_named(room)) said.push_back(fmt::format("the room \"{}\"", room.name));
  }
  if (const auto edits = stored_edits(store).size(); edits > 0) {
    said.push_back(counted(edits, "correction") + " by hand");
  }
  return said;
}

/// What `former` holds and `now` has not.
std::vector<std::string> lost_by(const fs::path& former_file, const fs::path& now_file) try {
  std::vector<std::string> lost;
  for (const std::string& name : added_by_others(former_file)) {
    lost.push_back(fmt::format("the table {}", printable(name)));
  }
  std::error_code missing;
  if (fs::is_empty(former_file, missing)) return lost;
  const GeoPackageStore former(former_file, GeoPackageStore::Mode::read);
  const GeoPackageStore now(now_file, GeoPackageStore::Mode::read);
  if (!is_of_another_building(former, now)) return lost;
  for (std::string& said : said_in(former)) lost.push_back(std::move(said));
  return lost;
} catch (const InputError& error) {
  return {fmt::format("what cannot be read ({})", error.what())};
}

fs::path free_name_beside(const fs::path& place) {
  fs::path beside = place;
  std::error_code missing;
  for (int number = 1; number == 1 || fs::exists(beside, missing); ++number) {
    const std::string mark = number == 1 ? ".former" : fmt::format(".former-{}", number);
    beside.replace_filename(place.stem().string() + mark + place.extension().string());
  }
  return beside;
}

void move_file(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw InputError(to.string() + ": cannot be replaced: " + error.message());
}

}  // namespace

void remove_side_files(const fs::path& store) {
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    std::error_code ignored;
    fs::remove(store.string() + ending, ignored);
  }
}

void replace_store(const fs::path& place, const fs::path& by) {
  std::error_code ignored;
  if (fs::exists(place, ignored)) {
    fs::permissions(by, fs::status(place, ignored).permissions(), ignored);
    if (const std::vector<std::string> lost = lost_by(place, by); !lost.empty()) {
      const fs::path beside = free_name_beside(place);
      move_file(place, beside);
      spdlog::warn("{}: what was there stays as {}: it holds what the new one has not: {}",
                   place.string(), beside.string(), fmt::join(lost, ", "));
    }
  }
  remove_side_files(place);
  move_file(by, place);
}

}  // namespace roomatlas::apps
