// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/store.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// A mission as it was assembled: its readings, where they were taken, and what was drawn of them.
struct AssembledMission {
  const AsrSource* source = nullptr;  ///< with readings; outlives this
  Placement placement;                ///< of its ASRs, in the frame of the plan; those without a
                                      ///< place are left out
  FloorPlan plan;
  RobotFootprint footprint;
};

/// A plan in another frame; its ids and names stay.
[[nodiscard]] FloorPlan moved(FloorPlan plan, const Pose2& to_from_here);

}  // namespace roomatlas
