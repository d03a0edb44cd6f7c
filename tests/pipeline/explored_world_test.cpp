// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way: a robot explores a world by itself, its odometry drifts, and the plan that comes
// out is compared with the world.
#include <gtest/gtest.h>

#include "pipeline/memory_mission.hpp"
#include "roomatlas/io/formats.hpp"
#include "roomatlas/simulate/explore.hpp"

namespace roomatlas {
namespace {

using namespace test;

class ExploredWorld : public testing::TestWithParam<const char*> {};

TEST_P(ExploredWorld, ComesBackAsItsPlan) {
  const std::string name = std::string(GetParam()) + ".geojson";
  const FloorPlan world = read_plan(Path(ROOMATLAS_SOURCE_DIR) / "data" / "worlds" / name);
  SimulationOptions robot;
  robot.sensor = SensorKind::laser;
  std::vector<MissionEvent> events;
  (void)explore(world, robot, {}, [&](const SimulatedStep& step) {
    events.emplace_back(step.reading);
    events.emplace_back(step.truth);
  });
  const MemoryStore store = mapped(events);
  const Assembly assembly = assemble(store, robot.footprint, {});
  const PlacedMission placed = place(store, assembly.correction);
  Truth truth;
  truth.plan = world;
  for (const TruePose& pose : store.true_poses) {
    truth.poses.push_back({pose.timestamp_s, pose.world_from_robot});
  }
  const Evaluation judged = evaluate(placed.odometry, placed.corrected, assembly.plan, truth);
  EXPECT_LT(judged.true_poses->after.position_m.mean, 0.05);
  EXPECT_EQ(judged.plan->strict.f1, 1.0) << "rooms at IoU 0.75";
  EXPECT_EQ(judged.plan->door_score.f1, 1.0);
  EXPECT_LT(judged.plan->mean_door_distance_m, 0.1);
  EXPECT_TRUE(judged.plan->graph->as_matched) << "the same graph, room by room";
}

INSTANTIATE_TEST_SUITE_P(WithALaser, ExploredWorld,
                         testing::Values("identical_rooms", "nine_rooms", "slanted_and_curved"));

}  // namespace
}  // namespace roomatlas
