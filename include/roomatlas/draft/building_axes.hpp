// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/draft/evidence.hpp"
#include "roomatlas/rooms/mapped_building.hpp"

namespace roomatlas {

/// The frame in which a building is drafted: its walls run along the axes, the first pose is the
/// origin and looks along x, as nearly as that goes. However the mission's frame is turned, the
/// building's cells then lie alike, and so do the cells of a building aslant and of a straight one.
/// @returns the pose of the mission's frame in that one; the identity without readings
/// @param jobs threads at once, see `for_each_index`
/// @throws InputError for an ASR without its readings
[[nodiscard]] Pose2 axes_from_building(const AsrSource& source, const Placement& placement,
                                       const GatherOptions& options, int jobs = 1);

/// Each ASR as it lies in another frame.
[[nodiscard]] Placement moved(Placement placement, const Pose2& to_from_here);

/// The same building in another frame.
[[nodiscard]] MappedBuilding moved(MappedBuilding building, const Pose2& to_from_here);

}  // namespace roomatlas
