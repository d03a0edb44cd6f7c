// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/io/files/path.hpp"

namespace roomatlas {

/// Held while a file is opened that is read once, and let go before it is read, so that a pipe is
/// as good as a file (`<(command)` of a shell) and nothing hangs: one into which nobody writes is
/// refused, and so are devices, which may have no end. Says nothing of files that are missing.
class PipeWatch {
 public:
  /// @throws InputError for a device, and for a pipe that has nothing to read within 5 s
  explicit PipeWatch(const Path& file);
  ~PipeWatch();
  PipeWatch(const PipeWatch&) = delete;
  PipeWatch& operator=(const PipeWatch&) = delete;

 private:
  int descriptor_ = -1;  ///< a writer, too: a reader's opening waits for one
};

/// Throws InputError for what gives its content once only, such as a pipe, and is read more than
/// once. Not for a missing file or a folder: a reader has better words for these.
void require_regular_file(const Path& file);

/// The content of a file that is read as a whole.
/// @throws InputError where it cannot be opened
[[nodiscard]] std::string read_text_file(const Path& file);

}  // namespace roomatlas
