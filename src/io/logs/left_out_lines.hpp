// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/mission/mission.hpp"

#include <map>
#include <string>

namespace roomatlas::io {

/// Lines of a log that could not be read, by tag.
class LeftOutLines {
 public:
  /// @param tag empty where it is not known
  /// @param line of the file; `why` is what was found and expected
  void add(const std::string& tag, std::int64_t line, const std::string& why);

  /// For a log that was read to its end: puts an error first among the issues where the log has no
  /// range reading, or no odometry, because every line that should hold one was left out.
  void explain(MissionInfo& info) const;

 private:
  struct Lines {
    std::int64_t count = 0;
    std::int64_t first_line = 0;
    std::string why;
  };
  static constexpr std::size_t kMostTags = 64;  ///< in some formats any word may be one

  std::map<std::string, Lines> of_tag_;
};

}  // namespace roomatlas::io
