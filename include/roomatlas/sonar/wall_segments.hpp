// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// One return of a sonar: where the sonar was and how far away it heard something.
struct ConeReturn {
  Point2 sonar = Point2::Zero();
  double axis_rad = 0.0;              ///< where it looked, in the same frame
  double range_m = 0.0;               ///< above 0
  Point2 axis = direction(axis_rad);  ///< of unit length; asked for many times in each fit
};

/// A wall as a line: the points p with normal . p = offset, the normal pointing from the robot to
/// the wall.
struct ConeLine {
  double normal_rad = 0.0;  ///< [-pi, pi)
  double offset_m = 0.0;
  double sigma_m = 0.0;                   ///< root mean square of the range residuals
  Point2 normal = direction(normal_rad);  ///< of unit length; asked for with each return
};

/// The range at which a sonar hears a straight wall: the distance d where the perpendicular lies
/// in the cone, and d / cos(alpha - h) on the cone's edge where the wall's normal is alpha off the
/// axis and alpha exceeds half the cone h. Nothing for a wall behind the sonar, or nearly
/// along the cone's edge.
[[nodiscard]] std::optional<double> range_to_line(const ConeReturn& from, double half_cone_rad,
                                                  const ConeLine& line);

/// The line that the returns of one sonar lie on, by least squares of the range residuals; nothing
/// for fewer than three returns or where the iteration does not settle.
[[nodiscard]] std::optional<ConeLine> fit_line(std::span<const ConeReturn> returns,
                                               double half_cone_rad);

/// The point of the line that a return came from.
[[nodiscard]] Point2 foot_of(const ConeReturn& from, double half_cone_rad, const ConeLine& line);

/// A stretch of wall as one sonar heard it in consecutive readings, in the robot's frame at one of
/// them.
struct WallSegment {
  std::size_t reading = 0;  ///< the one in the middle: its robot frame is meant
  double normal_rad = 0.0;  ///< from the robot to the wall, [-pi, pi)
  Point2 middle_robot = Point2::Zero();
  double length_m = 0.0;
  double sigma_m = 0.0;  ///< root mean square of its returns' residuals
};

struct WallSegmentOptions {
  double step_m = 0.04;        ///< readings nearer to the one before are passed over: they hear the
                               ///< same noise again
  double turn_rad = 0.05;      ///< unless the robot has turned by this
  int min_returns = 4;         ///< fewer make walls out of furniture
  double tolerance_m = 0.05;   ///< of a return: 1.7 to 2.5 sigmas of the range noise
  double max_path_m = 2.0;     ///< longer bends by the drift of the heading
  double min_path_m = 0.3;     ///< shorter shows no direction
  double max_turn_rad = 0.35;  ///< of the robot, along one segment; more bends it
  double min_length_m = 0.4;   ///< of the wall that was touched; shorter ones are furniture
  double min_range_m = 0.15;   ///< nearer, a sonar hears its own ringing
  double max_range_m = 4.0;    ///< farther returns come from many things at once
  int max_misses = 2;          ///< returns in a row that may lie elsewhere; more joins two walls
};

/// Walls from consecutive returns of each sonar, ordered by reading. Lasers are passed over.
/// @param map_from_robot one pose a reading, good over a few metres: odometry is enough
/// @param path_m length of the path up to each reading, not decreasing
/// @param jobs threads at once, see `for_each_index`
[[nodiscard]] std::vector<WallSegment> wall_segments(std::span<const RangeReading> readings,
                                                     std::span<const Pose2> map_from_robot,
                                                     std::span<const double> path_m,
                                                     const WallSegmentOptions& options,
                                                     int jobs = 1);

}  // namespace roomatlas
