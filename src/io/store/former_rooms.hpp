// SPDX-License-Identifier: GPL-3.0-or-later
// The table `former_rooms`: the rooms of the store that this one replaces, until an assembly has
// carried their numbers and names over; and all rooms, where named ones are absent from the plan.
#pragma once

#include <vector>

#include "database.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

// Parts of a transaction:
void create_former_rooms(Database& db);
/// Replaces what was there; makes the table where an earlier release did not.
void write_former_rooms(Database& db, const std::vector<PlanRoom>& rooms);

/// Ascending by id; numbers, names, areas and polygons.
[[nodiscard]] std::vector<PlanRoom> read_former_rooms(Database& db);

}  // namespace roomatlas
