// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/pose2.hpp"

#include <cstdint>
#include <optional>
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
[[nodiscard]] std::vector<double> times_of(const Trajectory& trajectory);

/// A number of seconds that brings a trajectory's times onto the truth's.
struct TimeOffset {
  double offset_s = 0.0;  ///< to add to the trajectory's times
  double share = 0.0;     ///< of the truth's times that then have a pose within 40 ms, (0, 1]
};

/// The offset that most pairs of times agree on, within 40 ms; nothing where fewer than half of the
/// truth's times have a pose then. Evenly stamped times fit at many offsets: of equals the one
/// nearest to the beginnings' difference. Looks at 200 of the truth's times at most.
[[nodiscard]] std::optional<TimeOffset> fitting_offset(const std::vector<double>& trajectory_s,
                                                       const std::vector<double>& truth_s);

/// Why no time of the truth has a pose of the trajectory: both ranges, the likely cause (another
/// clock, another unit, another recording) and the flag that helps.
[[nodiscard]] std::string explain_mismatch(const std::vector<double>& trajectory_s,
                                           const std::vector<double>& truth_s);

/// What looks wrong in a trajectory before it is compared with anything: no poses, one pose, NaN,
/// times in milliseconds or nanoseconds, clocks that step back (a note). `name` names it.
[[nodiscard]] Issues check_trajectory(const Trajectory& trajectory, const std::string& name);

/// "[1211.520, 2272.700] s".
[[nodiscard]] std::string to_string(const TimeRange& range);

}  // namespace roomatlas
