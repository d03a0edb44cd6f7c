// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/store.hpp"
#include "roomatlas/assembly/assembly.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace roomatlas {

/// What a mission was recorded with, and with that how it is corrected. Decided once, from the
/// ASRs.
enum class MissionKind {
  laser,  ///< the robot was found in its rooms: rooms are matched with each other by their walls
          ///< (`match_rooms` off: by doorways, as the paper's, but decided on all readings). One
          ///< whose map is doubtful (`kTrusted`) is corrected as a whole then
  sonar,  ///< sonars alone: the mission is corrected as a whole, and its rooms recorded again
  paper,  ///< nothing but odometry and doorways, as the paper has it: where the robot was not found
          ///< in its rooms, where readings were not kept, and where `correct_sonars` is off
};

/// @param source not empty
[[nodiscard]] MissionKind mission_kind(const AsrSource& source, const AssembleOptions& options);

/// Offline stage: ASRs -> room graph -> correction -> rooms -> floor plan.
/// @param options those that the ASRs were mapped with, and how they are assembled
/// @throws UsageError where the mission has no answer of the number asked for
/// @throws NotEnoughError when the source holds no ASR, Interrupted when `progress` says so
[[nodiscard]] Assembly assemble(const AsrSource& source, const RobotFootprint& footprint,
                                const Options& options, const Progress& progress = {});

}  // namespace roomatlas
