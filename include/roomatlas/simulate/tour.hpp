// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/floor_plan.hpp"
#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas {

struct TourOptions {
  RobotFootprint footprint;
  double view_m = 2.5;  ///< each place of a room comes so near to the drive or nearer, as far as
                        ///< the robot gets there; smaller drives longer
};

/// A drive through all rooms that a robot gets to, as somebody would steer it who knows the
/// building: all of a room first, then the nearest place that is left. Rooms with wide openings,
/// which an exploring robot sees from outside, are entered too.
/// @param start where the robot stands
/// @throws InputError where there is no room, or the robot gets nowhere from `start`
[[nodiscard]] Drive tour(const FloorPlan& world, const Point2& start, const TourOptions& options);

}  // namespace roomatlas
