// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "roomatlas/mission/mission.hpp"
#include "roomatlas/pipeline/pipeline.hpp"
#include "roomatlas/simulate/simulate.hpp"
#include "support/drawn_world.hpp"
#include "support/memory_store.hpp"

namespace roomatlas::test {

/// A mission that is a list of events.
class MemoryMission : public MissionSource {
 public:
  explicit MemoryMission(std::vector<MissionEvent> events, std::string odometry = "ODOM lines")
      : events_(std::move(events)) {
    info_.file = "memory.clf";
    info_.odometry = std::move(odometry);
  }
  std::optional<MissionEvent> next() override {
    if (next_ == events_.size()) return std::nullopt;
    const bool is_reading = std::holds_alternative<RangeReading>(events_[next_]);
    (is_reading ? info_.readings : info_.true_poses) += 1;
    return events_[next_++];
  }
  [[nodiscard]] const MissionInfo& info() const override { return info_; }
  [[nodiscard]] double progress() const override {
    return events_.empty() ? 1.0 : static_cast<double>(next_) / static_cast<double>(events_.size());
  }

 private:
  std::vector<MissionEvent> events_;
  std::size_t next_ = 0;
  MissionInfo info_;
};

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
