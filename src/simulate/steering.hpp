// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "explorer_map.hpp"
#include "route.hpp"

#include <vector>

namespace roomatlas {

/// What the robot does in one period: it turns, then drives.
struct Steering {
  double turn_rad = 0.0;
  double length_m = 0.0;
};

struct SteeringLimits {
  double max_length_m = 0.04;  ///< in one period
  double max_turn_rad = 0.08;  ///< in one period
};

/// One step along a way, by the polar histogram (paper II.A, equations (1) to (3)): of the
/// directions near the way's, the one with little in it. A step that would touch what is in the
/// map or in the last sweep is not made: the robot turns, or backs off.
/// @param way in the map's frame, from the robot's place to the goal; empty: nothing is done
/// @param hits_map where the last sweep ended at obstacles, in the map's frame
[[nodiscard]] Steering steer(const ExplorerMap& map, const std::vector<Point2>& hits_map,
                             const Pose2& map_from_robot, const RobotFootprint& footprint,
                             const Polyline& way, const SteeringLimits& limits);

/// The points of a reading at which a beam met an obstacle near enough to matter.
[[nodiscard]] std::vector<Point2> near_hits(const RangeReading& reading,
                                            const Pose2& map_from_robot);

}  // namespace roomatlas
