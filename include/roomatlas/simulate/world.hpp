// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <vector>

namespace roomatlas {

/// Of an open door's leaf, as it stands in the way.
constexpr double kLeafThickness_m = 0.04;

/// What an open leaf takes up on the floor: its line from hinge to free end, of that thickness.
/// Empty for a leaf of no length.
[[nodiscard]] Ring leaf_outline(const Segment2& leaf);

/// The leaves of the doors that stand open, in the order of the doors.
[[nodiscard]] std::vector<Polygon> open_leaves(const FloorPlan& world);

/// What is wrong with a plan as a world to drive through; empty where nothing is.
/// Errors: there is no wall; two rooms cover more than 0.1 m2 of the same floor (a millimetre
/// along a long wall is rounding). Warnings: rooms that no door joins to the rest ("closed off");
/// a door that names no room on either side. Notes: there are no doors at all, or no rooms.
/// Errors come first; within one severity the order is that of the plan.
[[nodiscard]] Issues check_world(const FloorPlan& world);

/// Throws InputError with all errors that `check_world` finds, one a line.
void require_sound(const FloorPlan& world);

/// How far the nearest wall, piece of furniture or open leaf is from `point` (world metres); 0
/// inside of one, infinite where there is none.
[[nodiscard]] double clearance_m(const FloorPlan& world, const Point2& point);

/// Throws InputError unless a robot can stand at `point` (world metres): outside of walls,
/// furniture and open leaves, at least `clearance_m` from them, and in a room or door where the
/// world has rooms. The message names the place, the nearest obstacle, and a place that is free.
void require_free(const FloorPlan& world, const Point2& point, double clearance_m);

}  // namespace roomatlas
