// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "roomatlas/draft/occupancy.hpp"
#include "roomatlas/rooms/partition_rooms.hpp"

namespace roomatlas {

struct JoinRoomsOptions {
  double sure_probability = 0.6;  ///< likelier openings part, and so do narrower ones than ...
  double widest_sure_m = 1.3;     ///< openings up to this may be doors wherever they are
  double widening_m = 0.3;  ///< a wider one is narrower by this than the floor on both sides ...
  double wall_share = 0.7;  ///< ... or has this much wall beyond each of its jambs
};

/// Joins rooms that a wide opening does not part: around a corridor's corner the floor is as wide
/// as the opening on one side, and no wall goes on beyond one of its jambs.
void join_rooms(const Occupancy& bare, const JoinRoomsOptions& options, RoomPartition& partition);

/// Joins the rooms on both sides of each opening that does not part them.
void join_rooms(const std::function<bool(const Opening&)>& parts, RoomPartition& partition);

}  // namespace roomatlas
