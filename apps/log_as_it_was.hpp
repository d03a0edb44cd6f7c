// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>

#include "roomatlas/core/issue.hpp"

namespace roomatlas::apps {

/// A log that something wrote to while it was read: its map and its digest are not of one log.
struct ChangedLog : InputError {
  using InputError::InputError;
};

/// Size and time of change of a log, see `files_of_log`, at one moment.
class LogAsItWas {
 public:
  explicit LogAsItWas(std::filesystem::path log);
  /// @throws ChangedLog where they are others now
  void require_unchanged() const;

 private:
  struct State {
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type changed;
    bool operator==(const State&) const = default;
  };
  [[nodiscard]] std::map<std::filesystem::path, State> states() const;

  std::filesystem::path log_;
  std::map<std::filesystem::path, State> then_;
};

}  // namespace roomatlas::apps
