// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/draft/evidence.hpp"
#include "roomatlas/grid/tile_grid.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// When what was seen, in what several missions saw one after the other.
struct VisitTimes {
  std::map<AsrId, std::uint16_t> of_visit;  ///< 0, 1, 2 ...: the later the larger
  TileGrid<std::uint16_t> since;  ///< a cell was altered then: what earlier visits say of it holds
                                  ///< no more. Cells of `GatherOptions::cell_m`

  /// Whether what a visit says of a cell still holds.
  [[nodiscard]] bool holds(AsrId visit, const Cell& cell) const {
    return of_visit.at(visit) >= since.at(cell);
  }
};

/// A mission as it was assembled: its readings, where they were taken, and what was drawn of them.
struct AssembledMission {
  const AsrSource* source = nullptr;  ///< with readings; outlives this
  Placement placement;                ///< of its ASRs, in the frame of the plan; those without a
                                      ///< place are left out
  FloorPlan plan;
  RobotFootprint footprint;
  const BuildingEvidence* evidence = nullptr;  ///< of all this, where it was gathered already
  const VisitTimes* times = nullptr;           ///< of its visits, where it is several missions
};

/// A plan in another frame; its ids and names stay.
[[nodiscard]] FloorPlan moved(FloorPlan plan, const Pose2& to_from_here);

}  // namespace roomatlas
