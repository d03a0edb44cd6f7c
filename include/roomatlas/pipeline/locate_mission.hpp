// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/assembly/assembly_store.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/join/place_mission.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace roomatlas {

/// Where a robot was in a building.
struct LocatedMission {
  PlaceVerdict verdict = PlaceVerdict::nothing_in_common;
  std::vector<MissionPlace> places;  ///< the likeliest first; may be empty
  std::vector<double> odds;          ///< of each place, [0, 1]
  double nowhere_odds = 1.0;         ///< that it is none of them; all add up to 1
  Trajectory building_from_robot;    ///< at the likeliest place, one pose a reading
};

/// How short pieces of a path are judged: a few metres see less than a mission.
[[nodiscard]] PlaceMissionOptions locating_options();

/// Looks for a few metres of a mission, or more, in a building of which it knows nothing. Its
/// readings are corrected among themselves first, as those of any mission.
/// @param asked visits as the online stage leaves them, with readings
/// @throws InputError where the building is not assembled or has no readings
[[nodiscard]] LocatedMission locate_mission(const AssemblyStore& building, const AsrSource& asked,
                                            const RobotFootprint& footprint, const Options& options,
                                            const Progress& progress = {});

}  // namespace roomatlas
