// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace roomatlas::io {

/// The PARAM lines that matter here, by CARMEN's own names. Offsets are along the robot's x axis,
/// forward positive.
struct CarmenParameters {
  std::optional<double> robot_length_m;           ///< robot_length
  std::optional<double> robot_width_m;            ///< robot_width
  std::optional<double> front_laser_offset_m;     ///< robot_frontlaser_offset
  std::optional<double> rear_laser_offset_m;      ///< robot_rearlaser_offset
  std::optional<double> front_laser_max_range_m;  ///< robot_front_laser_max
  std::optional<double> rear_laser_max_range_m;   ///< robot_rear_laser_max
  std::optional<double> sonar_max_range_m;        ///< robot_max_sonar

  /// @return empty, or what was expected and found, when the name is one of these but the value is
  ///   not usable: no number, or beyond what a robot or a sensor has; the former value then stays.
  [[nodiscard]] std::string set(std::string_view name, std::string_view value);
};

}  // namespace roomatlas::io
