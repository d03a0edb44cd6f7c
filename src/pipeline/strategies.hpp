// SPDX-License-Identifier: GPL-3.0-or-later
// The three ways of correcting a mission. Each takes the ASRs of the online stage and says where
// they truly lie; `assemble` does the rest alike for all.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "latest_building.hpp"
#include "roomatlas/asr/memory_store.hpp"
#include "roomatlas/asr/store.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/loops/close_loops.hpp"
#include "roomatlas/loops/closures.hpp"
#include "roomatlas/pipeline/assemble.hpp"
#include "roomatlas/pipeline/options.hpp"
#include "roomatlas/sonar/sonar_trajectory.hpp"

namespace roomatlas {

/// Where the ASRs of a mission truly lie, and how that was found.
struct CorrectedMission {
  RoomGraph graph;
  Correction correction;
  std::vector<Closure> closures;  ///< that were tried; none where rooms were not matched
  bool are_rooms_matched = false;
  bool are_edits_heard = true;              ///< false where matches stand as joining left them
  Paths paths;                              ///< of readings that were matched again; may be empty
  std::optional<SecondLoops> second_loops;  ///< another way to close them; sonars have their own
  std::optional<SonarTrajectory> sonars;
  VisitMoves moves;                 ///< of sonars
  std::optional<double> doubted;    ///< see `Assembly`
  std::set<AsrId> not_drawn;        ///< visits of sonars to what lasers saw
  std::vector<VisitsOfTime> times;  ///< of the visits that are drawn, where missions were driven
                                    ///< one after the other; else empty
  std::optional<MemoryStore> recorded_again;  ///< ASRs instead of those of the source
};

/// A match that holds, as a measurement of the graph.
[[nodiscard]] PassageEdge edge_of(const Closure& closure);

/// Of all ASRs, in the order in which they were recorded.
[[nodiscard]] std::vector<RangeReading> readings_of(const AsrSource& source);

/// Of visits that follow each other as in the trajectory, from which the moves are taken.
/// @param asrs with their paths
[[nodiscard]] VisitMoves take_moves(SonarTrajectory& trajectory, const std::vector<Asr>& asrs);

/// The maps of all ASRs, from readings that are loaded for as many ASRs at a time as there are
/// jobs.
[[nodiscard]] std::vector<AsrShape> shapes_of(const AsrSource& source, const Options& options);

/// Rooms are found again by their walls, and readings matched with all rooms that lie on their own.
[[nodiscard]] CorrectedMission correct_laser_mission(const AsrSource& source,
                                                     const Options& options,
                                                     const Progress& progress);

/// The readings of all rooms are corrected as one trajectory, and the rooms recorded anew from it.
[[nodiscard]] CorrectedMission correct_sonar_mission(const AsrSource& source,
                                                     const RobotFootprint& footprint,
                                                     const Options& options,
                                                     const Progress& progress);

/// The paper's: rooms turn about their pivots, which are doorways that were seen again.
[[nodiscard]] CorrectedMission correct_paper_mission(const std::vector<Asr>& asrs,
                                                     const Options& options);

/// By that of them which is meant for its kind.
[[nodiscard]] CorrectedMission correct_mission(MissionKind kind, const AsrSource& source,
                                               const RobotFootprint& footprint,
                                               const Options& options, const Progress& progress);

/// A mission with a laser whose map is doubtful, corrected anew: the poses of
/// all its readings as one trajectory, as those of sonars are. Which visits are of one room stays
/// as it was.
/// @param doubted its map by matched rooms, judged
/// @returns nothing where walls do not speak for it, where readings were not kept, are not all of
///   lasers, or too many (`SingleBeams`), and where somebody said how visits lie or asked for
///   another answer: then matches decide
[[nodiscard]] std::optional<CorrectedMission> correct_as_a_whole(const AsrSource& source,
                                                                 const Assembly& doubted,
                                                                 const Options& options,
                                                                 const Progress& progress);

/// The rest, alike for all: rooms, plan, judgement.
[[nodiscard]] Assembly assemble_corrected(MissionKind kind, const AsrSource& source,
                                          CorrectedMission corrected,
                                          const RobotFootprint& footprint, const Options& options,
                                          const Progress& progress);

}  // namespace roomatlas
