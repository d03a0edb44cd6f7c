// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "roomatlas/changes/assembled_mission.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/draft/evidence.hpp"
#include "roomatlas/plan/change.hpp"

namespace roomatlas {

/// Nearer than this the middles of two doors, in two plans of a building, are those of one.
inline constexpr double kSameDoor_m = 0.5;

/// When something is a change.
struct ChangeOptions {
  GatherOptions evidence;
  // Cells of `evidence.cell_m`. Something stands in one where lasers were reflected:
  int min_hits = 3;
  double standing_share = 0.3;  ///< of the beams; lower takes people who walked by
  // Nothing does where they were not, and nothing near it:
  int min_passes = 4;
  double clear_share = 0.04;  ///< of the beams at most are reflected
  double apart_m = 0.15;      ///< from anything that was hit; smaller takes errors of the maps for
                              ///< changes, and what moved by less is not told
  // What is one thing:
  double join_m = 0.1;         ///< gaps up to twice this are bridged
  int min_cells = 5;           ///< smaller is noise
  double min_lasting_s = 2.0;  ///< most of its cells were hit over this long; people walk on
  int min_readings = 5;        ///< of each mission
  double least_standing =
      0.5;  ///< of the readings that met it in the mission in which it stands: in
            ///< more of them it stopped a beam, rather than that all went through
  // What it is:
  double door_reach_m = 0.3;      ///< across a wall, of what stands in its doors
  double leaf_reach_m = 0.15;     ///< from a leaf as it was drawn
  double wall_reach_m = 0.12;     ///< from the faces of a wall as drawn
  double longest_across_m = 0.4;  ///< of a wall, ...
  double shortest_wall_m = 0.8;   ///< ... which is longer than this
  double like_size_m = 0.25;      ///< sides of what moved differ by no more ...
  double moved_m = 6.0;           ///< ... and it moved no farther
  double wall_moved_m = 2.0;      ///< the same of a wall, across it
  // What was not seen again:
  double min_unseen_m2 = 0.5;  ///< smaller pieces of floor are corners
};

/// Plans of both missions, the old one first: they say what is a door and what a wall.
struct PlansOfBoth {
  FloorPlan before;
  FloorPlan after;
};

/// The changes of `find_changes` alone, where plans are dear.
/// @param plans asked once, where anything changed; those of the missions are not looked at
/// @returns none for sonars
[[nodiscard]] std::vector<Change> changes_between(const AssembledMission& before,
                                                  const AssembledMission& after,
                                                  const ChangeOptions& options,
                                                  const std::function<PlansOfBoth()>& plans,
                                                  const Progress& progress = {}, int jobs = 1);

/// What changed between two missions. A change has been seen by both: see `Change`. What one of
/// them did not see is never one.
/// @param after in the frame of `before`, see `lay_on`
/// @param jobs threads at once, see `for_each_index`
/// @throws InputError for an ASR without its readings, Interrupted when `progress` says so
[[nodiscard]] PlanChanges find_changes(const AssembledMission& before,
                                       const AssembledMission& after, const ChangeOptions& options,
                                       const Progress& progress = {}, int jobs = 1);

}  // namespace roomatlas
