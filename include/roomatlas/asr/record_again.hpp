// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/asr/memory_store.hpp"
#include "roomatlas/asr/recorder.hpp"

namespace roomatlas {

/// A mission's rooms, recorded again from better poses.
struct RecordedAgain {
  MemoryStore asrs;     ///< with readings
  Placement placement;  ///< where the poses put them
};

/// Records the rooms of a mission anew: doorways are found, rooms cut and mapped where the poses
/// put the readings. The rooms count as localized, since their paths fit each other.
/// @param map_from_robot one a reading
[[nodiscard]] RecordedAgain record_again(const std::vector<RangeReading>& readings,
                                         const std::vector<Pose2>& map_from_robot,
                                         const RobotFootprint& footprint,
                                         const RecorderOptions& options);

}  // namespace roomatlas
