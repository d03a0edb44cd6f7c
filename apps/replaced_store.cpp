// SPDX-License-Identifier: GPL-3.0-or-later
#include "replaced_store.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "printable.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/edit/edit.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/store/store_use.hpp"
#include "roomatlas/merge/carry_over.hpp"
#include "store_edits.hpp"
#include "store_metadata.hpp"

namespace roomatlas::apps {
namespace {

namespace fs = std::filesystem;

std::string in_words(const PlanRoom& room) { return fmt::format("the room \"{}\"", room.name); }

/// What people said of the building in it.
std::vector<std::string> said_in(const GeoPackageStore& store) {
  std::vector<std::string> said;
  for (const PlanRoom& room : store.former_rooms()) {
    if (is_named(room)) said.push_back(in_words(room));
  }
  if (const auto edits = stored_edits(store).size(); edits > 0) {
    said.push_back(counted(edits, "correction") + " by hand");
  }
  return said;
}

/// What was said of the same building since the new store took over all that had been said.
std::vector<std::string> said_since(const GeoPackageStore& former, const GeoPackageStore& now) {
  std::set<std::string> names;
  for (const PlanRoom& room : now.former_rooms()) names.insert(room.name);
  std::set<RoomId> renamed;
  std::set<std::string> statements;
  for (const Edit& edit : stored_edits(now)) {
    statements.insert(as_told(edit));
    if (edit.kind == EditKind::name_room) renamed.insert(edit.rooms.front().id.value_or(0));
  }
  std::vector<std::string> said;
  for (const PlanRoom& room : former.former_rooms()) {
    const bool is_kept = names.contains(room.name) || renamed.contains(room.id);
    if (is_named(room) && !is_kept) said.push_back(in_words(room));
  }
  if (now.has_assembly()) return said;  // `--edits` may have taken statements back, and told of it
  const std::vector<Edit> edits = stored_edits(former);
  const auto lost = std::count_if(edits.begin(), edits.end(), [&](const Edit& edit) {
    return !statements.contains(as_told(edit));
  });
  if (lost > 0) said.push_back(counted(lost, "correction") + " by hand");
  return said;
}

/// What `former` holds and `now` has not.
std::vector<std::string> lost_by(const fs::path& former_file, const fs::path& now_file) try {
  std::vector<std::string> lost;
  if (holds_nothing(former_file)) return lost;
  for (const std::string& added : added_by_others(former_file)) lost.push_back(printable(added));
  const GeoPackageStore former(former_file, GeoPackageStore::Mode::read);
  const GeoPackageStore now(now_file, GeoPackageStore::Mode::read);
  const bool is_carried_over = may_be_of(former.metadata(), building_of(now.metadata()));
  std::vector<std::string> said = is_carried_over ? said_since(former, now) : said_in(former);
  std::move(said.begin(), said.end(), std::back_inserter(lost));
  return lost;
} catch (const InputError& error) {
  return {fmt::format("what cannot be read ({})", error.what())};
}

fs::path free_name_beside(const fs::path& place) {
  fs::path beside = place;
  std::error_code missing;
  for (int number = 1; number == 1 || fs::exists(fs::symlink_status(beside, missing)); ++number) {
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

/// Few have any.
void move_side_files(const fs::path& of, const fs::path& to) {
  for (const char* ending : kSideFiles) {
    std::error_code missing;
    fs::rename(of.string() + ending, to.string() + ending, missing);
  }
}

/// A second name, so that the place is never empty; the only one where a file has only one.
void keep_as(const fs::path& beside, const fs::path& place) {
  std::error_code error;
  fs::create_hard_link(place, beside, error);
  if (error && error != std::errc::file_exists) fs::rename(place, beside, error);
  if (error) refuse(place, error);
  move_side_files(place, beside);
}

/// @throws InputError that says why the place was not taken
[[noreturn]] void put_back(const fs::path& place, const fs::path& beside,
                           const std::error_code& why) {
  std::error_code error;
  if (beside.empty()) refuse(place, why);
  fs::rename(beside, place, error);  // does nothing where both are names of one file
  if (fs::equivalent(beside, place, error)) fs::remove(beside, error);
  move_side_files(beside, place);
  refuse(place, why);
}

}  // namespace

void remove_side_files(const fs::path& store) {
  for (const char* ending : kSideFiles) {
    std::error_code ignored;
    fs::remove(store.string() + ending, ignored);
  }
}

void replace_store(const fs::path& named, const fs::path& by) {
  const fs::path place = behind_links(named);
  require_no_other_user(place);
  std::error_code error;
  if (fs::equivalent(place, by, error)) {
    throw std::invalid_argument(place.string() + ": a store does not replace itself");
  }
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
