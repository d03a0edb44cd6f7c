// SPDX-License-Identifier: GPL-3.0-or-later
// Missions in known worlds with the poses that the robot truly had: what drafting makes of exact
// poses.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "roomatlas/asr/memory_store.hpp"
#include "roomatlas/draft/draft_building.hpp"
#include "roomatlas/io/logs/drive.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/simulate/furnish.hpp"
#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas::test {

inline const std::filesystem::path kWorlds =
    std::filesystem::path(ROOMATLAS_SOURCE_DIR) / "data" / "worlds";

struct KnownMission {
  FloorPlan world;
  MemoryStore store;  ///< of one ASR in the building's frame
  BuildingEvidence evidence;
};

/// A world of `data/worlds`, driven through.
/// @param building_from_world how the building's frame lies
/// @param furnish_seed of what stands in the rooms; 0: nothing
inline KnownMission known_mission(const std::string& world, const Drive& drive, SensorKind sensor,
                                  const Pose2& building_from_world,
                                  std::uint64_t furnish_seed = 0) {
  KnownMission mission{read_plan((kWorlds / world).replace_extension("geojson")), {}, {}};
  SimulationOptions robot;
  robot.sensor = sensor;
  if (furnish_seed > 0) {
    FurnishOptions options;
    options.route = drive;
    mission.world = furnished(std::move(mission.world), furnish_seed, options);
  }
  Asr asr;
  asr.id = 1;
  simulate(mission.world, drive, robot, [&](const SimulatedStep& step) {
    asr.path.push_back({step.truth.timestamp_s, building_from_world * step.truth.world_from_robot,
                        step.odometry.odom_from_robot});
    asr.readings.push_back(step.reading);
  });
  mission.store.put(asr);
  mission.evidence = gather_evidence(mission.store, {{1, Pose2{}}}, robot.footprint, {}, {});
  return mission;
}

/// Whether as many rooms were drafted as there are, each where it is.
/// @param area_share of a room's area, by which it may be off
inline void expect_rooms_of(const FloorPlan& world, const DraftedBuilding& drafted,
                            double area_share) {
  EXPECT_EQ(drafted.rooms.size(), world.rooms.size());
  for (const PlanRoom& room : world.rooms) {
    const auto found = std::find_if(
        drafted.rooms.begin(), drafted.rooms.end(),
        [&](const DraftedRoom& one) { return contains(one.outline, room.label_point); });
    ASSERT_NE(found, drafted.rooms.end()) << room.name;
    EXPECT_NEAR(area(found->outline), room.area_m2, area_share * room.area_m2) << room.name;
  }
}

/// `eight_rooms`, driven through all its doors.
inline KnownMission eight_rooms(SensorKind sensor, const Pose2& building_from_world,
                                std::uint64_t furnish_seed = 0) {
  return known_mission("eight_rooms", read_drive(kWorlds / "eight_rooms.drive"), sensor,
                       building_from_world, furnish_seed);
}

}  // namespace roomatlas::test
