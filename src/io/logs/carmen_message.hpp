// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace roomatlas::io {

/// What kind of message a known tag announces.
enum class CarmenKind { odometry, laser, sonar, true_pose, parameter };

/// Where a laser sits by its tag. Tags 3 and 4 say nothing about it.
enum class LaserPlace { front, rear, elsewhere };

/// A tag that the reader knows.
struct CarmenTag {
  std::string_view name;
  CarmenKind kind;
  LaserPlace place = LaserPlace::elsewhere;
};

/// The tag of that name; null when it is unknown. The pointer is valid for ever.
[[nodiscard]] const CarmenTag* find_carmen_tag(std::string_view name);
/// True when a known tag begins with these characters: a tag that was cut short, perhaps.
[[nodiscard]] bool begins_carmen_tag(std::string_view text);
/// The known tags, for a message to a person.
[[nodiscard]] std::string list_carmen_tags();

/// The part of a laser or sonar line that is not the trailer.
struct CarmenScan {
  std::vector<float> ranges_m;
  bool has_poses = false;  ///< the line has pose slots; they may still be all zero
  Pose2 odom_from_laser;
  Pose2 odom_from_robot;

  double start_rad = 0.0;  ///< laser: direction of the first beam, from the laser's x axis
  double step_rad = 0.0;   ///< laser: from one beam to the next, counter-clockwise
  bool directions_assumed =
      false;                 ///< laser: the count is unusual, 180 degrees are taken for granted
  double max_range_m = 0.0;  ///< laser: as on the line; 0 where it does not say

  std::vector<Pose2> robot_from_sonar;
  double cone_rad = 0.0;  ///< sonar: as on the line, full opening angle
};

/// One line, taken apart. Reused from line to line: only what its kind names is meaningful.
struct CarmenMessage {
  const CarmenTag* tag = nullptr;
  std::optional<double> timestamp_s;
  int trailing_fields = 0;  ///< timestamp, host, logger time: how many of them the line has
  Pose2 pose;               ///< ODOM: of the robot in odometry; TRUEPOS: the true one
  CarmenScan scan;
  std::string name;       ///< PARAM
  std::string value;      ///< PARAM; empty where the line has none
  std::int64_t line = 0;  ///< its number in the file, from 1
};

/// Why a line could not be taken apart.
struct CarmenProblem {
  std::string field;  ///< empty where the line as a whole is at fault
  std::string message;
};

}  // namespace roomatlas::io
