// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/simulate/simulate.hpp"

#include <cstddef>
#include <vector>

namespace roomatlas {

/// One straight piece of a drive, of positive length.
struct Leg {
  std::size_t number = 0;  ///< from way-point `number` to the next, 1-based
  Segment2 line;
};

/// The legs of a drive; way-points that repeat their predecessor make none. Throws InputError for
/// a way-point that is not finite or where fewer than two points differ.
[[nodiscard]] std::vector<Leg> legs_of(const Drive& drive);

/// Throws InputError naming the first leg that enters a wall, furniture or an open leaf, or comes
/// closer to one than `clearance_m`.
void require_clear(const FloorPlan& world, const std::vector<Leg>& legs, double clearance_m);

/// A pure translation or a pure turn at constant speed.
struct Motion {
  double start_s = 0.0;  ///< since the start of the drive
  double duration_s = 0.0;
  Pose2 world_from_start;
  double length_m = 0.0;
  double turn_rad = 0.0;
};

/// The drive over time: never empty, without gaps. The robot starts looking along the first leg.
using Route = std::vector<Motion>;

[[nodiscard]] Route route_along(const std::vector<Leg>& legs, const SimulationOptions& options);

/// Turns, drives straight to another pose and turns there as that one stands. What lies between is
/// not looked at.
[[nodiscard]] Route way_back(const Pose2& world_from_robot, const Pose2& world_from_goal,
                             const SimulationOptions& options);

[[nodiscard]] double duration_s(const Route& route);

/// The robot's true pose; before the start or after the end of the route, its first or last.
[[nodiscard]] Pose2 world_from_robot_at(const Route& route, double time_s);

/// What was driven from `from_s` to `to_s`, as pure motions in order.
[[nodiscard]] std::vector<Motion> motions_between(const Route& route, double from_s, double to_s);

}  // namespace roomatlas
