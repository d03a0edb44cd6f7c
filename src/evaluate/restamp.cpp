// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/restamp.hpp"

#include "roomatlas/evaluate/time_ranges.hpp"
#include "time_runs.hpp"

#include <cmath>
#include <cstdio>

namespace roomatlas {

Restamped restamp(const Trajectory& logger_stamped, const std::vector<ClockReading>& clock,
                  double max_difference_s) {
  std::vector<double> logger_s;
  for (const ClockReading& reading : clock) logger_s.push_back(reading.logger_s);
  const evaluation::TimeRuns runs(logger_s);
  Restamped result;
  for (const StampedPose& stamped : logger_stamped) {
    const auto place = runs.nearest(stamped.timestamp_s);
    if (!place) continue;
    const double difference_s = std::abs(logger_s[*place] - stamped.timestamp_s);
    if (!(difference_s <= max_difference_s)) continue;
    result.largest_difference_s = std::fmax(result.largest_difference_s, difference_s);
    result.trajectory.push_back({clock[*place].timestamp_s, stamped.pose});
  }
  const std::size_t lost = logger_stamped.size() - result.trajectory.size();
  if (lost > 0) {
    char limit[32];
    std::snprintf(limit, sizeof limit, "%.3g", max_difference_s);
    const bool none = result.trajectory.empty();
    result.issues.push_back(
        {none ? Severity::error : Severity::warning, "", 0, "--stamps-from",
         std::to_string(lost) + " of " + std::to_string(logger_stamped.size()) +
             " poses are farther than " + limit +
             " s from every scan by the logger's clock and are left out: the poses span " +
             to_string(time_range(logger_stamped)) + ", the log's logger times " +
             to_string(time_range(logger_s)) +
             (none ? "; is it the log that they come from?" : "")});
  }
  return result;
}

bool has_own_stamps(const Trajectory& trajectory, const std::vector<ClockReading>& clock) {
  std::vector<double> timestamps_s;
  for (const ClockReading& reading : clock) timestamps_s.push_back(reading.timestamp_s);
  const evaluation::TimeRuns runs(timestamps_s);
  std::size_t equal = 0;
  for (const StampedPose& stamped : trajectory) {
    if (runs.same_microsecond(stamped.timestamp_s)) ++equal;
  }
  return 2 * equal > trajectory.size();
}

Trajectory shifted(Trajectory trajectory, double offset_s) {
  for (StampedPose& stamped : trajectory) stamped.timestamp_s += offset_s;
  return trajectory;
}

Trajectory moved(Trajectory trajectory, const Pose2& pose_from_point) {
  for (StampedPose& stamped : trajectory) stamped.pose = stamped.pose * pose_from_point;
  return trajectory;
}

}  // namespace roomatlas
