// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace roomatlas::io {

/// A file's descriptor, and whether this process has it alone.
struct LockedFile {
  int descriptor = -1;    ///< to be closed by the caller; -1: cannot be opened, `error` says why
  bool is_taken = false;  ///< another process holds the lock
  int error = 0;          ///< errno
};

/// Opens a file for reading and writing, or makes it, and locks it (flock(2)) without waiting and
/// without emptying it. Where the file system has no locks, the file is opened without one.
[[nodiscard]] LockedFile open_locked(const std::filesystem::path& file);

}  // namespace roomatlas::io
