// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/plan/room_ids.hpp"

namespace roomatlas {

std::set<RoomId> room_ids(const FloorPlan& plan) {
  std::set<RoomId> ids;
  for (const PlanRoom& room : plan.rooms) ids.insert(room.id);
  return ids;
}

}  // namespace roomatlas
