// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

/// The same motion as odometry and as the sensor itself has it, each in its own frame before it.
struct SeenMotion {
  Pose2 of_robot;
  Pose2 of_sensor;
};

/// Where a sensor sits on its robot, and how sure that is.
struct SensorMount {
  Pose2 robot_from_sensor;
  double position_sigma_m = 0.0;
  double heading_sigma_rad = 0.0;
  double off_m = 0.0;         ///< of motions, from what the mount makes of them, root mean square
  double off_rad = 0.0;       ///< of their turns
  double length_scale = 1.0;  ///< of the sensor's ways over odometry's
  double left_rad = 0.0;      ///< turns that were seen ...
  double right_rad = 0.0;
  double way_m = 0.0;  ///< ... and ways
};

/// Solves `robot motion * mount = mount * sensor motion` for the mount (hand-eye calibration, in
/// the plane: Tsai and Lenz 1989) by least squares that let go of what does not fit. Turns tell the
/// lever arm, ways the direction.
/// @returns nothing where the motions are too few for it, or do not tell all three numbers
[[nodiscard]] std::optional<SensorMount> mount_from_motions(const std::vector<SeenMotion>& motions);

}  // namespace roomatlas
