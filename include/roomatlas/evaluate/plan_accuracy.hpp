// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/accuracy.hpp"
#include "roomatlas/plan/floor_plan.hpp"
#include "roomatlas/plan/judgement.hpp"

namespace roomatlas {

/// What can be said about a plan's accuracy without truth. Within a room: from the deviations of
/// the plan's measured edges. All else: as the map was judged.
/// @param judgement of the map; none of a finished one
/// @returns nothing estimated, and no extent, for a plan without rooms
[[nodiscard]] PlanAccuracy plan_accuracy(const FloorPlan& plan,
                                         const std::optional<Judgement>& judgement);

}  // namespace roomatlas
