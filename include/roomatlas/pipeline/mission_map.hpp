// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/store.hpp"
#include "roomatlas/join/place_mission.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace roomatlas {

/// A mission as others are matched with it: visits of lasers by the map of their room, those of
/// sonars by stretches of wall.
/// @param placement of its visits, in one frame
/// @throws InputError for a visit without its readings
[[nodiscard]] MissionMap mission_map_of(const AsrSource& source, const Placement& placement,
                                        const Options& options);

}  // namespace roomatlas
