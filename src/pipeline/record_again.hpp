// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "roomatlas/asr/memory_store.hpp"
#include "roomatlas/pipeline/pipeline.hpp"

namespace roomatlas {

/// A mission's rooms, recorded again from better poses.
struct RecordedAgain {
  MemoryStore asrs;     ///< with readings; `is_localized`, since their paths are consistent
  Placement placement;  ///< where the poses put them
};

/// The readings of a sonar mission in the order in which they were recorded; empty when any was
/// taken by a laser or when the source keeps none.
[[nodiscard]] std::vector<RangeReading> sonar_readings_of(const AsrSource& source);

/// Records the rooms of a mission anew: doorways are found, rooms cut and mapped where the poses
/// put the readings.
/// @param map_from_robot one a reading
[[nodiscard]] RecordedAgain record_again(const std::vector<RangeReading>& readings,
                                         const std::vector<Pose2>& map_from_robot,
                                         const RobotFootprint& footprint,
                                         const RecorderOptions& options);

}  // namespace roomatlas
