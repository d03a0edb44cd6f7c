// SPDX-License-Identifier: GPL-3.0-or-later
#include "replaced_store.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

#include "printable.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/store/store_use.hpp"
#include "roomatlas/merge/carry_over.hpp"
#include "store_edits.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {
namespace {

namespace fs = std::filesystem;

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
  std::vector<std::string> said = said_in(former);  // also where all of it was to be carried over
  if (may_be_of(former.metadata(), building_of(now.metadata()))) return lost;
  std::move(said.begin(), said.end(), std::back_inserter(lost));
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

[[noreturn]] void refuse(const fs::path& place, const std::error_code& error) {
  throw InputError(place.string() + ": cannot be replaced: " + error.message() +
                   "; check the folder and its permissions");
}

constexpr std::array<const char*, 3> kSideFiles = {"-wal", "-shm", "-journal"};

/// A second name, so that the place is never empty; the only one where a file has only one.
void keep_as(const fs::path& beside, const fs::path& place) {
  std::error_code error;
  fs::create_hard_link(place, beside, error);
  if (error) fs::rename(place, beside, error);
  if (error) refuse(place, error);
  for (const char* ending : kSideFiles) {
    fs::rename(place.string() + ending, beside.string() + ending, error);  // few have any
  }
}

/// @throws InputError that says why the place was not taken
[[noreturn]] void put_back(const fs::path& place, const fs::path& beside,
                           const std::error_code& why) {
  std::error_code error;
  if (!beside.empty()) fs::rename(beside, place, error);  // nothing where both name one file,
  if (fs::equivalent(beside, place, error)) fs::remove(beside, error);
  refuse(place, why);
}

}  // namespace

void remove_side_files(const fs::path& store) {
  for (const char* ending : kSideFiles) {
    std::error_code ignored;
    fs::remove(store.string() + ending, ignored);
  }
}

void replace_store(const fs::path& place, const fs::path& by) {
  require_no_other_user(place);
  std::error_code error;
  std::vector<std::string> lost;
  if (fs::exists(place, error)) {
    give_permissions_of(place, by);
    lost = lost_by(place, by);
  }
  const fs::path beside = lost.empty() ? fs::path() : free_name_beside(place);
  if (!lost.empty()) keep_as(beside, place);
  remove_side_files(place);
  if (fs::rename(by, place, error); error) put_back(place, beside, error);
  if (lost.empty()) return;
  spdlog::warn("{}: what was there stays as {}: it holds what the new one has not: {}",
               place.string(), beside.string(), fmt::join(lost, ", "));
}

}  // namespace roomatlas::apps
