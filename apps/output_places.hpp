// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "roomatlas/io/files/place_lock.hpp"

namespace roomatlas::apps {

// What is asked before a command works, so that `-o` destroys nothing but a former result. All
// throw InputError with the place, the reason and what to do.

/// Makes the folder, and those above it, where they are missing.
void make_folder(const std::filesystem::path& folder);

/// Refuses a folder that is an input, or lies in one: a recording is what its folder holds.
void require_output_folder(const std::filesystem::path& folder,
                           const std::vector<std::filesystem::path>& inputs);

/// Refuses a folder, a device or another special file, and a file that is read by the same command
/// or would be lost under the temporary names of the output. No name is refused too.
void require_output_file(const std::filesystem::path& file,
                         const std::vector<std::filesystem::path>& inputs);

/// The same of several, of which no two may be one file. Those without a name are not written.
void require_output_files(const std::vector<std::filesystem::path>& files,
                          const std::vector<std::filesystem::path>& inputs);

/// The same for a store, which replaces another store or an empty file alone.
void require_output_store(const std::filesystem::path& file,
                          const std::vector<std::filesystem::path>& inputs);

/// The same, and from then on no other run may write there, and no other program does. What a run
/// that was killed left beside the store is removed; a store that it had finished is put in its
/// place.
[[nodiscard]] PlaceLock lock_new_store(const std::filesystem::path& file,
                                       const std::vector<std::filesystem::path>& inputs);

/// A store that is there and is to be changed.
[[nodiscard]] PlaceLock lock_store(const std::filesystem::path& file);

/// A store is an SQLite file, whatever its name.
[[nodiscard]] bool is_sqlite(const std::filesystem::path& file);

}  // namespace roomatlas::apps
