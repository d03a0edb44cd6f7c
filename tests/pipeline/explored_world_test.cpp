// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way: a robot explores a world by itself, its odometry drifts, and the plan that comes
// out is compared with the world.
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/memory_mission.hpp"
#include "roomatlas/asr/with_paths.hpp"
#include "roomatlas/core/pose2.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/correct/wall_direction.hpp"
#include "roomatlas/evaluate/evaluation.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/merge/regular_walls.hpp"
#include "roomatlas/pipeline/assemble.hpp"
#include "roomatlas/simulate/explore.hpp"
#include "support/print_values.hpp"

namespace roomatlas {
namespace {

using namespace test;

struct Exploration {
  const char* world;
  SensorKind sensor;
  double largest_mean_m;  ///< of the position error
  std::uint64_t seed = 1;
};

void PrintTo(const Exploration& exploration, std::ostream* out) {
  *out << exploration.world << ", ";
  PrintTo(exploration.sensor, out);
  *out << ", seed " << exploration.seed;
}

std::string name_of(const testing::TestParamInfo<Exploration>& exploration) {
  return exploration.param.world + std::string("_") + std::to_string(exploration.param.seed);
}

/// Of the direction of most walls against the axes.
double turn_of_walls(const FloorPlan& plan) {
  std::vector<PlacedOutline> outlines;
  for (const PlanRoom& room : plan.rooms) {
    for (const Polygon& part : room.parts) outlines.push_back({0, room.id, part});
  }
  return wrap_quarter(building_directions(outlines, {}).at(0));
}

class ExploredWorld : public testing::TestWithParam<Exploration> {};

TEST_P(ExploredWorld, ComesBackAsItsPlan) {
  const std::string name = std::string(GetParam().world) + ".geojson";
  const FloorPlan world = read_plan(Path(ROOMATLAS_SOURCE_DIR) / "data" / "worlds" / name);
  SimulationOptions robot;
  robot.sensor = GetParam().sensor;
  robot.seed = GetParam().seed;
  std::vector<MissionEvent> events;
  (void)explore(world, robot, {}, [&](const SimulatedStep& step) {
    events.emplace_back(step.reading);
    events.emplace_back(step.truth);
  });
  MemoryStore store = mapped(events);
  Assembly assembly = assemble(store, robot.footprint, {});
  if (!assembly.mapped_again.empty()) store.asrs = std::move(assembly.mapped_again);
  const PlacedMission placed = place(WithPaths(store, assembly.paths), assembly.correction);
  Truth truth;
  truth.plan = world;
  for (const TruePose& pose : store.true_poses) {
    truth.poses.push_back({pose.timestamp_s, pose.world_from_robot});
  }
  const Evaluation judged = evaluate(placed.odometry, placed.corrected, assembly.plan, truth);
  EXPECT_LT(judged.true_poses->after.position_m.mean, GetParam().largest_mean_m);
  EXPECT_LT(std::abs(degrees(turn_of_walls(assembly.plan))), 0.4);
  EXPECT_EQ(judged.plan->strict.f1, 1.0) << "rooms at IoU 0.75";
  EXPECT_EQ(judged.plan->door_score.f1, 1.0);
  EXPECT_LT(judged.plan->mean_door_distance_m, 0.1);
  EXPECT_TRUE(judged.plan->graph->as_matched) << "the same graph, room by room";
}

INSTANTIATE_TEST_SUITE_P(WithALaser, ExploredWorld,
                         testing::Values(Exploration{"identical_rooms", SensorKind::laser, 0.05},
                                         Exploration{"nine_rooms", SensorKind::laser, 0.05},
                                         Exploration{"slanted_and_curved", SensorKind::laser,
                                                     0.05}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(WithSonars, ExploredWorld,
                         // in 11 the walls of two rooms can be taken for one, which bends odometry
                         testing::Values(Exploration{"nine_rooms", SensorKind::sonar, 0.3},
                                         Exploration{"nine_rooms", SensorKind::sonar, 0.3, 11}),
                         name_of);

}  // namespace
}  // namespace roomatlas
