// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_places.hpp"

#include <fstream>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>

#include "new_store.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/store/store_use.hpp"

namespace roomatlas::apps {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& place, const std::string& reason) {
  throw InputError(place.string() + ": " + reason);
}

/// Follows links; false where a file is missing or cannot be asked.
bool are_the_same(const fs::path& one, const fs::path& other) {
  std::error_code missing;
  return fs::equivalent(one, other, missing);
}

void require_place_of_a_file(const fs::path& file) {
  if (file.empty()) throw InputError("the output has no name: give a file with -o FILE");
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::status_known(status)) {
    refuse(file, "cannot be written: " + error.message() + "; give another name with -o");
  }
  if (fs::is_directory(status)) {
    refuse(file, "is a directory, expected a file name: give -o FOLDER/FILE");
  }
  constexpr std::size_t kLongest = 230;  // 255, less what is written beside it on the way
  if (file.filename().string().size() > kLongest) {
    refuse(file, "its name is too long: give one of at most 230 bytes");
  }
  const fs::path folder = file.parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error)) {
    refuse(file, "cannot be written: there is no folder " + folder.string() + ": make it first");
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    refuse(file, "is a device or another special file, which is not replaced: give a plain file");
  }
}

/// @param endings of the names that are written on the way to the file
void require_no_input(const fs::path& file, const std::vector<fs::path>& inputs,
                      std::initializer_list<const char*> endings) {
  for (const char* ending : endings) {
    const fs::path written = file.string() + ending;
    for (const fs::path& input : inputs) {
      if (are_the_same(written, input)) {
        refuse(written, "is an input of this command and would be lost: give another name with -o");
      }
    }
  }
}

}  // namespace

void make_folder(const fs::path& folder) {
  if (folder.empty()) throw InputError("the output folder has no name: give it with -o FOLDER");
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    refuse(folder, "cannot be made as a folder: " + error.message() +
                       "; give another one, where no file is in the way");
  }
}

void require_output_folder(const fs::path& folder, const std::vector<fs::path>& inputs) {
  std::error_code unknown;
  const fs::path place = fs::weakly_canonical(fs::absolute(folder, unknown), unknown);
  for (fs::path above = place; above.has_relative_path(); above = above.parent_path()) {
    for (const fs::path& input : inputs) {
      if (!fs::is_directory(input, unknown) || !are_the_same(above, input)) continue;
      refuse(folder, "results do not go into the recording " + input.string() +
                         ", which they would change: give another folder with -o");
    }
  }
}

void require_output_file(const fs::path& file, const std::vector<fs::path>& inputs) {
  require_place_of_a_file(file);
  require_no_input(file, inputs, {"", ".part"});
}

void require_output_files(const std::vector<fs::path>& files, const std::vector<fs::path>& inputs) {
  std::set<fs::path> places;
  for (const fs::path& file : files) {
    if (file.empty()) continue;
    require_output_file(file, inputs);
    std::error_code unknown;
    if (!places.insert(fs::weakly_canonical(fs::absolute(file, unknown), unknown)).second) {
      refuse(file, "is named for two outputs, of which one would be lost: give each its own name");
    }
  }
}

void require_output_store(const fs::path& file, const std::vector<fs::path>& inputs) {
  require_place_of_a_file(file);
  require_no_input(behind_links(file), inputs, {"", ".tmp", ".new", ".new.tmp"});
  std::error_code missing;
  if (!fs::exists(file, missing) || fs::is_empty(file, missing)) return;
  if (is_sqlite(file) && !is_recording(file)) return;
  refuse(file,
         "is there already and is no store, so it is not replaced: give another name with -o");
}

PlaceLock lock_new_store(const fs::path& file, const std::vector<fs::path>& inputs) {
  require_output_store(file, inputs);
  PlaceLock lock(file);
  require_no_other_user(file);
  remove_leftovers(file);
  settle_new_store(file);
  return lock;
}

PlaceLock lock_store(const fs::path& file) {
  (void)GeoPackageStore(file, GeoPackageStore::Mode::read);  // says what is wrong with it
  PlaceLock lock(file);
  require_no_other_user(file);
  remove_leftovers(file);
  return lock;
}

bool is_sqlite(const fs::path& file) {
  std::error_code unreadable;
  if (!fs::is_regular_file(file, unreadable)) return false;  // a pipe would lose its beginning
  constexpr std::string_view kMagic = "SQLite format 3";
  std::string head(kMagic.size(), '\0');
  std::ifstream(file, std::ios::binary)
      .read(head.data(), static_cast<std::streamsize>(head.size()));
  return head == kMagic;
}

}  // namespace roomatlas::apps
