// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/pose2.hpp"

#include <string>
#include <vector>

namespace roomatlas {

/// One range scan's time by two clocks: when its logger wrote it, and its own timestamp.
struct ClockReading {
  double logger_s = 0.0;
  double timestamp_s = 0.0;
};

struct Restamped {
  Trajectory trajectory;
  double largest_difference_s = 0.0;  ///< between a pose's time and the scan that it was given
  Issues issues;                      ///< poses that no scan is near of, counted; they are left out
};

/// Gives each pose, stamped by the logger's clock, the timestamp of the scan whose logger time is
/// nearest. Times may step back in either list.
/// @param max_difference_s a pose farther from every scan is left out; the corrected logs print
///   six digits, so that 5 ms are lost after 1000 s
[[nodiscard]] Restamped restamp(const Trajectory& logger_stamped,
                                const std::vector<ClockReading>& clock,
                                double max_difference_s = 0.05);

/// Whether a trajectory carries the log's own timestamps already: most of its times equal one of
/// them to the microsecond. False for no poses.
[[nodiscard]] bool has_own_stamps(const Trajectory& trajectory,
                                  const std::vector<ClockReading>& clock);

/// The trajectory with every time later by `offset_s`.
[[nodiscard]] Trajectory shifted(Trajectory trajectory, double offset_s);

/// The trajectory of another point of the robot: each pose moved on by `pose_from_point`, in its
/// own frame.
[[nodiscard]] Trajectory moved(Trajectory trajectory, const Pose2& pose_from_point);

}  // namespace roomatlas
