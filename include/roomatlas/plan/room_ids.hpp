// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/floor_plan.hpp"

#include <set>

namespace roomatlas {

/// Of all rooms, for who asks of many: `has_room` looks at one room after the other.
[[nodiscard]] std::set<RoomId> room_ids(const FloorPlan& plan);

}  // namespace roomatlas
