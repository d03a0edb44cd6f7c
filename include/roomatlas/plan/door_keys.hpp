// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// A name for each door of the plan, in their order, by the rooms that it joins: "3-4", a second
/// one between the same rooms, by its place, "3-4-2", and "3-out" where the robot was on one side
/// alone
/// ("out-out" where no room is known). Unlike a door's number it is the same when another assembly
/// lists the doors in another order. No two are alike.
[[nodiscard]] std::vector<std::string> door_keys(const FloorPlan& plan);

}  // namespace roomatlas
