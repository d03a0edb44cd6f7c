// SPDX-License-Identifier: GPL-3.0-or-later
// What a drive is, and when it counts as reversed: for the stream and for the whole mission.
#pragma once

#include "roomatlas/odometry/drive_directions.hpp"

namespace roomatlas {

/// As odometry has it, in the robot's frame at the first reading.
[[nodiscard]] Pose2 reported_step(const RangeReading& from, const RangeReading& to);

/// Whether a step is so short that the robot may have turned from forwards to backwards: it ends a
/// drive.
[[nodiscard]] bool is_stop(const Pose2& step, const DriveDirectionOptions& options);

/// Whether two readings so far apart can tell the direction.
[[nodiscard]] bool can_tell(double apart_m, const DriveDirectionOptions& options);

/// @param log_odds of reversed against reported, of a whole drive
[[nodiscard]] DriveDirection decided(double log_odds, const DriveDirectionOptions& options);

}  // namespace roomatlas
