// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/assembly/assembly_store.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/join/judge_places.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace roomatlas {

/// Where a robot was in a building.
struct LocatedMission {
  /// Placed: the likeliest place is right with a probability of `kSurePlace` at least.
  PlaceVerdict verdict = PlaceVerdict::nothing_in_common;
  SensorKind sensor = SensorKind::laser;
  std::vector<MissionPlace> places;   ///< the likeliest first; may be empty
  std::vector<double> odds;           ///< of each place, [0, 1]
  double nowhere_odds = 1.0;          ///< that it is none of them; all add up to 1
  Trajectory building_from_robot;     ///< at the likeliest place, one pose a reading
  std::vector<JudgedFigure> figures;  ///< that the likeliest place's odds are made from
};

/// How short pieces of a path are looked for: a few metres see less than a mission.
[[nodiscard]] PlaceMissionOptions locating_options(double way_m);

/// A building in which missions are looked for. Made once for many of them.
class MissionLocator {
 public:
  /// @param known visits of the building, each where the building has it
  /// @param options must outlive it
  MissionLocator(const MissionMap& known, const Options& options);

  /// Looks for a few metres of a mission, or more. Its readings are corrected among themselves
  /// first, as those of any mission.
  /// @param asked visits as the online stage leaves them, with readings
  /// @throws InputError where it has no readings
  [[nodiscard]] LocatedMission locate(const AsrSource& asked, const RobotFootprint& footprint,
                                      const Progress& progress = {}) const;

 private:
  const Options& options_;
  BuildingIndex index_;
};

/// The same for one mission, in a building as it is stored.
/// @throws InputError where the building is not assembled or has no readings
[[nodiscard]] LocatedMission locate_mission(const AssemblyStore& building, const AsrSource& asked,
                                            const RobotFootprint& footprint, const Options& options,
                                            const Progress& progress = {});

}  // namespace roomatlas
