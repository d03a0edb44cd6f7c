// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "roomatlas/changes/assembled_mission.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/match/match_maps.hpp"
#include "roomatlas/match/room_localizer.hpp"

namespace roomatlas {

/// How one mission's building is laid on another's.
struct LayOnOptions {
  LocalizeOptions localize;  ///< how readings become a map
  MatchMapsOptions match;
  SearchWindow around{3.0, radians(20.0)};  ///< the guess; wider takes longer
  int min_agreeing = 150;  ///< of 1500 points of the new map: fewer walls in common prove nothing
  double min_agreement = 0.5;  ///< of the points that can tell. Lower than between two visits of a
                               ///< mission: a building may be altered
  // Each visit is then laid on the old map by itself, where maps bend otherwise:
  SearchWindow settle{0.6, radians(3.0)};  ///< around where the whole put it
  int settle_min_telling = 80;             ///< points of it that can tell; fewer leave it there
  double settle_min_agreement = 0.55;      ///< of these; with less it is laid nowhere else ...
  double settle_gain = 0.2;                ///< ... nor with less more than where the whole put it
  double stay_min_agreement = 0.35;        ///< there; with less it is left out
};

/// The guesses of who knows nothing: both missions began at about the same place, and their
/// buildings' axes may be quarter turns apart, since each looks along the wall that is nearest.
[[nodiscard]] std::vector<Pose2> quarter_turns();

/// A mission in another one's frame.
struct LaidOn {
  Pose2 old_from_new;
  Placement placement;     ///< old_from_asr of the new mission's ASRs, but for those that
                           ///< contradict the old map wherever they are laid
  double agreement = 0.0;  ///< of the points of the new map that can tell, [0, 1]
};

/// Lays the laser map of a mission on that of another, near the best of some guesses.
/// @param guesses_old_from_new of the two building frames
/// @returns nothing where the two have too little in common. Without laser readings of both there
/// is
///   nothing to match by: a single guess is believed then, of several none
/// @throws InputError for an ASR without its readings, Interrupted when `progress` says so
[[nodiscard]] std::optional<LaidOn> lay_on(const AssembledMission& before,
                                           const AssembledMission& after,
                                           const std::vector<Pose2>& guesses_old_from_new,
                                           const LayOnOptions& options,
                                           const Progress& progress = {});

}  // namespace roomatlas
