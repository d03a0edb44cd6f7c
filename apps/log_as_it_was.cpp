// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_as_it_was.hpp"

#include <utility>

#include "roomatlas/io/files/files.hpp"

namespace roomatlas::apps {

namespace fs = std::filesystem;

LogAsItWas::LogAsItWas(fs::path log) : log_(std::move(log)), then_(states()) {}

std::map<fs::path, LogAsItWas::State> LogAsItWas::states() const {
  std::map<fs::path, State> found;
  std::error_code error;
  for (const fs::path& file : files_of_log(log_)) {
    found[file] = {fs::file_size(file, error), fs::last_write_time(file, error)};
  }
  return found;
}

void LogAsItWas::require_unchanged() const {
  if (states() == then_) return;
  throw ChangedLog(log_.string() +
                   ": was written to while it was read, and no map was made of it: run the same "
                   "command again when whatever writes it has ended");
}

}  // namespace roomatlas::apps
