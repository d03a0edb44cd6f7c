// SPDX-License-Identifier: GPL-3.0-or-later
#include "new_store.hpp"

#include <spdlog/spdlog.h>

#include <optional>
#include <string>

#include "replaced_store.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "usable_store.hpp"

namespace roomatlas::apps {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFinishing = ".tmp";  // what `GeoPackageStore::finish` writes beside a store
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
  return read_if_possible(file, [](const GeoPackageStore& store) {
    return MadeSoFar{store.metadata().contains("mission_sha256"), store.has_assembly(),
                     store.unfinished().has_value()};
  });
}

}  // namespace

fs::path place_beside(const fs::path& place) { return place.string() + ".new"; }

NewStore::NewStore(const fs::path& place)
    : place_(behind_links(place)), file_(fs::exists(place_) ? place_beside(place_) : place_) {
  if (fs::is_directory(place)) {
    throw InputError(place.string() + ": is a directory, expected a file name for the store");
  }
  if (file_ != place_) create_like(file_, place_);
}

NewStore::NewStore(const fs::path& place, const fs::path& unfinished)
    : place_(behind_links(place)), file_(behind_links(unfinished)) {}

void NewStore::put_in_place() const {
  if (file_ != place_) return replace_store(place_, file_);
  remove_store(place_beside(place_));  // of an interrupted run, with which this one did not go on
}

fs::path NewStore::keep_unfinished() const {
  if (file_ == place_) return place_;
  const auto former = made_so_far(place_);
  if (!former || former->is_mapped || former->is_assembled) return file_;
  try {
    replace_store(place_, file_);
    return place_;
  } catch (const InputError&) {  // the next run finds it where it is
    return file_;
  }
}

void NewStore::give_up() const {
  const auto stage = made_so_far(file_);
  if (!stage || (!stage->is_mapped && !stage->is_unfinished)) return remove();
  spdlog::warn("{}: {} mapped in it; the next run goes on from there", file_.string(),
               stage->is_mapped ? "the whole mission is" : "the rooms so far are");
}

void NewStore::remove() const { remove_store(file_); }

void remove_leftovers(const fs::path& named) {
  const fs::path store = behind_links(named);
  for (const std::string& made : {store.string(), store.string() + kCopy}) {
    remove_store(made + kFinishing);
  }
  remove_store(store.string() + kCopy);
  std::error_code missing;
  if (!fs::exists(store, missing)) remove_side_files(store);
}

void put_copy_in_place(const fs::path& finished, const fs::path& named,
                       const std::function<void(const fs::path& copy)>& change) {
  const fs::path place = behind_links(named);
  const fs::path copy = place.string() + kCopy;  // not `.new`, which would be put in place as it is
  std::error_code error;
  fs::copy_file(finished, copy, fs::copy_options::overwrite_existing, error);
  if (error) {
    remove_store(copy);
    throw InputError(copy.string() + ": cannot be written: " + error.message() +
                     "; run the same command again where it can be");
  }
  if (fs::exists(place, error)) give_permissions_of(place, copy);
  try {
    change(copy);
  } catch (...) {
    remove_store(copy);
    throw;
  }
  replace_store(place, copy);
}

void settle_new_store(const fs::path& named) {
  const fs::path place = behind_links(named);
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
