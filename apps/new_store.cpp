// SPDX-License-Identifier: GPL-3.0-or-later
#include "new_store.hpp"

#include <spdlog/spdlog.h>

#include <optional>

#include "replaced_store.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

namespace roomatlas::apps {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCopy = ".copy.tmp";  // of a finished store, on its way to another place

void remove_store(const fs::path& store) {
  std::error_code ignored;
  fs::remove(store, ignored);
  remove_side_files(store);
}

/// How far a store of this version has come.
struct MadeSoFar {
  bool is_mapped = false;  ///< the whole mission is in it
  bool is_assembled = false;
  bool is_unfinished = false;  ///< some rooms of it, behind which a run can go on
};

/// None for a file that is missing or no store of this version.
std::optional<MadeSoFar> made_so_far(const fs::path& file) {
  try {
    const GeoPackageStore store(file, GeoPackageStore::Mode::read);
    return MadeSoFar{store.metadata().contains("mission_sha256"), store.has_assembly(),
                     store.unfinished().has_value()};
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

fs::path place_beside(const fs::path& place) { return place.string() + ".new"; }

NewStore::NewStore(const fs::path& place)
    : place_(place), file_(fs::exists(place) ? place_beside(place) : place) {
  if (fs::is_directory(place)) {
    throw InputError(place.string() + ": is a directory, expected a file name for the store");
  }
}

void NewStore::put_in_place() const {
  if (file_ != place_) return replace_store(place_, file_);
  remove_store(place_beside(place_));  // of an interrupted run, with which this one did not go on
}

fs::path NewStore::keep_unfinished() const {
  if (file_ == place_) return place_;
  const auto former = made_so_far(place_);
  if (!former || former->is_mapped || former->is_assembled) return file_;
  replace_store(place_, file_);
  return place_;
}

void NewStore::give_up() const {
  const auto stage = made_so_far(file_);
  if (!stage || (!stage->is_mapped && !stage->is_unfinished)) return remove();
  spdlog::warn("{}: {} mapped in it; the next run goes on from there", file_.string(),
               stage->is_mapped ? "the whole mission is" : "the rooms so far are");
}

void NewStore::remove() const { remove_store(file_); }

void remove_leftovers(const fs::path& store) {
  for (const char* ending : {".tmp", kCopy}) remove_store(store.string() + ending);
  std::error_code missing;
  if (!fs::exists(store, missing)) remove_side_files(store);
}

void put_copy_in_place(const fs::path& finished, const fs::path& place,
                       const std::function<void(const fs::path& copy)>& change) {
  const fs::path copy = place.string() + kCopy;  // not `.new`, which would be put in place as it is
  std::error_code error;
  fs::copy_file(finished, copy, fs::copy_options::overwrite_existing, error);
  if (error) {
    remove_store(copy);
    throw InputError(copy.string() + ": cannot be written: " + error.message() +
                     "; run the same command again where it can be");
  }
  try {
    change(copy);
  } catch (...) {
    remove_store(copy);
    throw;
  }
  replace_store(place, copy);
}

void settle_new_store(const fs::path& place) {
  const fs::path made = place_beside(place);
  const auto stage = made_so_far(made);
  if (!stage || !stage->is_mapped) {
    if (!stage || !stage->is_unfinished) remove_store(made);
    return;
  }
  GeoPackageStore(made, GeoPackageStore::Mode::update).finish();
  replace_store(place, made);
  spdlog::info("{}: a run before was stopped as it put its finished map here; this is done now",
               place.string());
}

}  // namespace roomatlas::apps
