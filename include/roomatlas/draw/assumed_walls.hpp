// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/floor_plan.hpp"

#include <vector>

namespace roomatlas {

/// The parts of a plan's walls that nobody measured, in building metres: behind edges that are
/// inferred or unexplored, as deep as the wall is there, and half of it where its other face was
/// measured; and the corners between them. They may overlap. Empty for a plan without edges.
[[nodiscard]] std::vector<Ring> assumed_walls(const FloorPlan& plan);

}  // namespace roomatlas
