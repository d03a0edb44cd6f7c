// SPDX-License-Identifier: GPL-3.0-or-later
// A laser mission with loops, and how far an estimate of its poses is off.
#pragma once

#include <vector>

#include "pipeline/memory_mission.hpp"
#include "roomatlas/evaluate/ape_rpe.hpp"
#include "roomatlas/io/logs/drive.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"

namespace roomatlas::test {

/// Three times round eight rooms and a corridor.
inline std::vector<MissionEvent> three_rounds(const SimulationOptions& options) {
  const Path world = Path(ROOMATLAS_SOURCE_DIR) / "data/worlds/eight_rooms";
  std::vector<MissionEvent> events;
  simulate(read_plan(world.string() + ".geojson"), read_drive(world.string() + ".drive"), options,
           [&](const SimulatedStep& step) {
             events.emplace_back(step.reading);
             events.emplace_back(step.truth);
           });
  return events;
}

/// The same with a laser that looks ahead.
inline std::vector<MissionEvent> three_rounds(OdometryPreset odometry) {
  SimulationOptions options;
  options.sensor = SensorKind::laser;
  options.odometry = odometry_errors(odometry);
  return three_rounds(options);
}

inline double rmse_m(const MemoryStore& store, const Trajectory& estimate) {
  Trajectory truth;
  for (const TruePose& pose : store.true_poses) {
    truth.push_back({pose.timestamp_s, pose.world_from_robot});
  }
  return ape(match_poses(estimate, truth, {}), {}).statistics.rmse;
}

}  // namespace roomatlas::test
