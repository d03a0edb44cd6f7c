// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <set>

#include "roomatlas/asr/memory_store.hpp"
#include "roomatlas/asr/with_paths.hpp"
#include "roomatlas/changes/assembled_mission.hpp"
#include "roomatlas/pipeline/assemble.hpp"
#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas::bench {

/// A mission that was simulated, mapped and assembled, in memory. It is where it is: not moved.
struct DrivenMission {
  MemoryStore store;
  Assembly assembly;
  std::unique_ptr<WithPaths> source;
  Pose2 world_from_building;  ///< as the whole path has it
  double off_m = 0.0;         ///< the farthest pose from where the robot truly was
  std::set<RoomId> entered;   ///< rooms of the world

  [[nodiscard]] AssembledMission mission() const;
};

/// Drives through a world, maps and assembles.
/// @throws what simulating, mapping and assembling throw
[[nodiscard]] std::unique_ptr<DrivenMission> driven(const FloorPlan& world, const Drive& drive,
                                                    const SimulationOptions& robot);

}  // namespace roomatlas::bench
