// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "cut_building.hpp"
#include "region_graph.hpp"

namespace roomatlas {

/// Takes out of a mission's floor what the robot only looked into and what can be no part of the
/// rooms it was in: not entered, with chords alone between it and the rest (a window, a door), and
/// mostly ended by what was not seen. A finished map stays as it is.
void drop_seen_through_walls(const std::vector<Pose2>& path, CutBuilding& cut);

/// Regions of a mission's floor that were not entered and of which too little was seen for a room:
/// small, or not bounded by walls for the most part. None in a finished map.
[[nodiscard]] std::set<std::int32_t> regions_not_known(const CutBuilding& cut,
                                                       const RegionGraph& graph,
                                                       const std::vector<Pose2>& path);

}  // namespace roomatlas
