// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/odometry/drive_directions.hpp"
#include "roomatlas/odometry/habits.hpp"
#include "roomatlas/sonar/wall_segments.hpp"

namespace roomatlas {

/// What speaks for a trajectory, however it was found.
struct TrajectoryMerit {
  double walls_m = 0.0;  ///< that several visits heard, less three times what others looked through
  OdometryHabits habits;  ///< with which odometry comes nearest to the trajectory; without lag
};

/// @param directions of the same readings
/// @param map_from_robot one a reading
[[nodiscard]] TrajectoryMerit trajectory_merit(std::span<const RangeReading> readings,
                                               const DriveDirections& directions,
                                               std::span<const Pose2> map_from_robot,
                                               const WallSegmentOptions& options, int jobs);

}  // namespace roomatlas
