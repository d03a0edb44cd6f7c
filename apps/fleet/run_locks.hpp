// SPDX-License-Identifier: GPL-3.0-or-later
// Who is alive and who has which mission, by locks on one file: the kernel gives them back when a
// process ends, however it ends.
#pragma once

#include <sys/types.h>

#include <cstddef>

#include "commands.hpp"

namespace roomatlas::apps {

/// A file of which each byte can be held by one process. It stays empty.
class RunLocks {
 public:
  /// @throws InputError where the file cannot be opened
  explicit RunLocks(const Path& file);
  ~RunLocks();
  RunLocks(const RunLocks&) = delete;
  RunLocks& operator=(const RunLocks&) = delete;

  static off_t rank(int rank) { return rank; }
  static off_t mission(std::size_t i) { return kMissions + 2 * static_cast<off_t>(i); }
  static off_t done(std::size_t i) { return mission(i) + 1; }

  /// Holds a byte until the process ends or gives it back. @returns false where another holds it
  /// @throws InputError where the file system has no locks
  bool take(off_t byte) const;
  void give_back(off_t byte) const;
  /// True where another process holds it.
  [[nodiscard]] bool is_held(off_t byte) const;

 private:
  static constexpr off_t kMissions = 1 << 20;  // beyond any number of ranks

  Path file_;
  int descriptor_;
};

}  // namespace roomatlas::apps
