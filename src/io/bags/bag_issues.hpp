// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/issue.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace roomatlas::io {

/// What was odd in a recording: each kind once, with how often it was met.
class BagIssues {
 public:
  explicit BagIssues(std::string file) : file_(std::move(file)) {}

  /// `what` is a sentence about one case; `things` (in the plural) are counted.
  void add(Severity severity, const std::string& what, const std::string& things = "",
           std::int64_t count = 0);
  /// Messages that were left out, of one chunk.
  void left_out(const std::string& what, std::int64_t messages);
  void take(const Issues& others);

  [[nodiscard]] Issues list() const;

 private:
  struct Kind {
    Severity severity = Severity::warning;
    std::string what;
    std::string things;
    std::int64_t count = 0;
    std::int64_t messages = 0;
  };

  std::string file_;
  std::vector<Kind> kinds_;
  Issues taken_;
};

}  // namespace roomatlas::io
