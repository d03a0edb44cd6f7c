// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "roomatlas/asr/checkpoint_sink.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/odometry/habits.hpp"
#include "roomatlas/pipeline/map_checkpoint.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace roomatlas {

/// What the online stage saw.
struct MapSummary {
  std::int64_t asrs = 0;
  std::int64_t wall_vertices = 0;
  int drives_reversed = 0;  ///< between stops, that odometry reported the wrong way round. Where
                            ///< the mission is corrected as a whole (sonars), its own count holds
  std::optional<OdometryHabits> habits;  ///< of odometry, learnt and taken out by the way (laser)
};

/// Online stage: a mission's events become ASRs in the sink, room by room.
/// @throws NotEnoughError when there are no range readings, no odometry, or no wall was seen (what
///   was mapped by then is in the sink), Interrupted when `progress` says so (the room being
///   mapped has been handed over)
[[nodiscard]] MapSummary map_mission(MissionSource& mission, AsrSink& sink,
                                     const MapOptions& options, const Progress& progress = {});

/// The same into a sink that keeps where to go on: with each ASR a checkpoint
/// (`map_checkpoint_of`).
/// @param from of a run of the same mission with the same options that was stopped, whose ASRs and
///   true poses up to there are in the sink, and no others. What comes is that run's, bit by bit.
///   The mission is read from its beginning, which costs little beside mapping it. InputError where
///   it ends before the checkpoint.
[[nodiscard]] MapSummary map_mission(MissionSource& mission, CheckpointSink& sink,
                                     const MapOptions& options,
                                     const std::optional<MapCheckpoint>& from,
                                     const Progress& progress = {});

}  // namespace roomatlas
