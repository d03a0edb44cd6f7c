// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "carmen_message.hpp"
#include "text/tokens.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace roomatlas::io {

/// Reads a line's fields in order. The first failure sticks: from then on nothing is read, so a
/// parser can name its fields one after the other and ask once at the end.
class FieldReader {
 public:
  /// @param line begins with the tag's name
  FieldReader(std::string_view tag, std::string_view line);

  /// A finite number.
  double number(const char* field);
  /// A place in the plane, by three finite numbers; the heading is wrapped. None of its coordinates
  /// is beyond `kFarthest_m`.
  Pose2 pose(const char* x_field, const char* y_field, const char* theta_field);
  /// A sensor's place on the robot: none of its coordinates is beyond `kFarthestMount_m`.
  Pose2 mount(const char* x_field, const char* y_field, const char* theta_field);
  /// A count and as many ranges.
  void ranges(std::vector<float>& ranges_m);
  /// A count and as many numbers, all of them dropped.
  void skip_counted(const char* field);
  std::string_view word() { return problem_ ? std::string_view() : fields_.next(); }
  [[nodiscard]] bool at_end() const { return fields_.at_end(); }
  [[nodiscard]] std::size_t fields_left() const { return problem_ ? 0 : fields_.count(); }

  /// True when what is left can only be `timestamp [host [logger_timestamp]]`: three numbers could
  /// be a pose.
  [[nodiscard]] bool is_trailer() const;

  void fail(std::string field, std::string message);
  /// The number of readings, as announced, does not fit the line.
  void fail_announced();
  [[nodiscard]] const std::optional<CarmenProblem>& problem() const { return problem_; }

 private:
  std::size_t count(const char* field);
  double coordinate(const char* field, double farthest_m, const char* expected);

  std::string_view tag_;
  Tokens fields_;
  std::size_t announced_ = 0;  ///< readings
  Tokens behind_announced_;
  std::optional<CarmenProblem> problem_;
};

}  // namespace roomatlas::io
