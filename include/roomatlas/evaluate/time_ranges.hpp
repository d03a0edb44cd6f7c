// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/pose2.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace roomatlas {

/// What times a list holds. `count` 0: none that is finite.
struct TimeRange {
  std::int64_t count = 0;
  double first_s = 0.0;  ///< smallest, wherever it stands
  double last_s = 0.0;   ///< largest
  std::int64_t steps_back = 0;
};
[[nodiscard]] TimeRange time_range(const std::vector<double>& times_s);
[[nodiscard]] TimeRange time_range(const Trajectory& trajectory);

/// Why no time of the truth has a pose of the trajectory: both ranges, the likely cause (another
/// clock, another unit, another recording) and the flag that helps.
[[nodiscard]] std::string explain_mismatch(const TimeRange& trajectory, const TimeRange& truth);

/// What looks wrong in a trajectory before it is compared with anything: no poses, one pose, NaN,
/// times in milliseconds or nanoseconds, clocks that step back (a note). `name` names it.
[[nodiscard]] Issues check_trajectory(const Trajectory& trajectory, const std::string& name);

/// "[1211.520, 2272.700] s".
[[nodiscard]] std::string to_string(const TimeRange& range);

}  // namespace roomatlas
