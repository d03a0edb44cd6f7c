// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "roomatlas/correct/place.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/pipeline/map_mission.hpp"
#include "roomatlas/simulate/simulate.hpp"
#include "support/drawn_world.hpp"
#include "support/memory_mission.hpp"
#include "support/memory_store.hpp"

namespace roomatlas::test {

inline std::vector<MissionEvent> events_of(const std::vector<RangeReading>& readings) {
  return {readings.begin(), readings.end()};
}

/// A sonar robot's mission along the drawing's way-points, with the truth of each reading.
inline std::vector<MissionEvent> sonar_mission(const WorldDrawing& drawing,
                                               const SimulationOptions& options = {}) {
  std::vector<MissionEvent> events;
  simulate(plan_of(drawing), way_points_of(drawing), options, [&](const SimulatedStep& step) {
    events.emplace_back(step.reading);
    events.emplace_back(step.truth);
  });
  return events;
}

/// The online stage alone, with default options.
inline MemoryStore mapped(const std::vector<MissionEvent>& events, const MapOptions& options = {}) {
  MemoryStore store;
  MemoryMission mission(events);
  const MapSummary summary = map_mission(mission, store, options);
  EXPECT_EQ(summary.asrs, static_cast<std::int64_t>(store.asrs.size()));
  return store;
}

/// Where building metres lie in the world, if the robot's first pose is known there.
inline Pose2 world_from_building(const PlacedMission& placed, const Pose2& world_from_first) {
  return world_from_first * inverse(placed.corrected.front().pose);
}

}  // namespace roomatlas::test
