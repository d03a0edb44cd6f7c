// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/correct/correction.hpp"
#include "roomatlas/plan/accuracy.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// What can be said about a plan's accuracy without truth (docs/method.md, "How accurate a plan
/// is"). Within a room: from the deviations of the plan's measured edges. Between rooms: as given.
/// Over the building: between rooms, and what a mission cannot show of itself, a share of the
/// longer side for its scale.
/// @param between_rooms_m standard deviation of a visit's place (`uncertainty_of`); nothing for a
///   mission that was corrected as one trajectory
/// @returns nothing estimated, and no extent, for a plan without rooms
[[nodiscard]] PlanAccuracy plan_accuracy(const FloorPlan& plan, const Correction& correction,
                                         std::optional<double> between_rooms_m);

}  // namespace roomatlas
