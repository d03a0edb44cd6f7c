// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/store.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/pipeline/options.hpp"

namespace roomatlas {

/// Where the robot was by one answer of several, whichever is drawn: one pose a reading, building
/// metres. The whole mission is assembled for it, and nothing of that is kept.
/// @param options `assemble.answer` says which, from 1
/// @throws UsageError where the mission has no such answer
[[nodiscard]] Trajectory answer_trajectory(const AsrSource& source, const RobotFootprint& footprint,
                                           const Options& options, const Progress& progress = {});

}  // namespace roomatlas
