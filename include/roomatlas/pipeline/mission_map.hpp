// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/store.hpp"
#include "roomatlas/join/place_mission.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace roomatlas {

/// What a visit looks like to a matcher: of a laser by the map of its room, of sonars alone by
/// stretches of wall.
/// @param asr with its readings
[[nodiscard]] AsrShape shape_of_visit(const Asr& asr, const Options& options);

/// A mission as others are matched with it: the shapes of its visits.
/// @param placement of its visits, in one frame
/// @throws InputError for a visit without its readings
[[nodiscard]] MissionMap mission_map_of(const AsrSource& source, const Placement& placement,
                                        const Options& options);

}  // namespace roomatlas
