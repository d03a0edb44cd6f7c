// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/draft_plan.hpp"

namespace roomatlas {

/// How each room's edges are known, in their order: stretches along which an obstacle was seen, and
/// others that continue a wall's line (inferred) or not (unexplored).
[[nodiscard]] std::vector<PlanEdge> edges_of(const std::vector<DraftedRoom>& rooms,
                                             const Walls& walls, const BuildingEvidence& evidence,
                                             const Occupancy& occupancy);

}  // namespace roomatlas
