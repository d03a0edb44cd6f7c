// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/io/files/path.hpp"

namespace roomatlas {

/// Keeps a second run out of a store or a folder while this one writes it. The operating system
/// holds the lock (flock(2) on a file of its own), so that a run that was killed leaves none
/// behind.
class PlaceLock {
 public:
  /// @param place a folder that exists (locked by `.roomatlas.lock` in it), or a file, which need
  ///   not exist yet (locked by FILE.lock beside it)
  /// @throws InputError when another run holds the place, naming its process, or when the lock
  ///   cannot be written; nothing has been touched then
  explicit PlaceLock(const Path& place);
  /// Removes the lock file.
  ~PlaceLock();
  PlaceLock(PlaceLock&& other) noexcept;
  PlaceLock& operator=(PlaceLock&&) = delete;

 private:
  Path file_;
  int descriptor_ = -1;
};

}  // namespace roomatlas
