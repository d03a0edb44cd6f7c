// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "furnish_site.hpp"
#include "furnish_ways.hpp"

#include <cstdint>
#include <map>

namespace roomatlas {

/// Opens the leaves of some doors; those that would be in the way stay closed, which is to say that
/// the plan has none there. A door that has a leaf keeps it.
/// @param ways of each room
void open_some_doors(FloorPlan& world, std::uint64_t seed, double share, FurnishSite& site,
                     std::map<RoomId, RoomWays>& ways);

}  // namespace roomatlas
