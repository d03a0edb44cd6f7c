// SPDX-License-Identifier: GPL-3.0-or-later
// The robot explores the worlds that we ship. The floor of the AFIT's size takes minutes:
// ./run paper drives through it.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <tuple>

#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/simulate/explore.hpp"
#include "support/print_values.hpp"

namespace roomatlas {
namespace {

using Case = std::tuple<std::string, SensorKind, std::uint64_t>;

class ExploredWorlds : public testing::TestWithParam<Case> {};

TEST_P(ExploredWorlds, EveryRoomIsEnteredWithoutACollision) {
  const auto& [name, sensor, seed] = GetParam();
  const FloorPlan world =
      read_plan(std::filesystem::path(ROOMATLAS_SOURCE_DIR) / "data/worlds" / (name + ".geojson"));
  SimulationOptions simulation;
  simulation.sensor = sensor;
  simulation.seed = seed;
  simulation.odometry = odometry_errors(OdometryPreset::typical);
  std::int64_t steps = 0;
  const ExploreSummary summary =
      explore(world, simulation, {}, [&](const SimulatedStep&) { ++steps; });
  EXPECT_TRUE(summary.finished);
  EXPECT_EQ(summary.collisions, 0);
  EXPECT_EQ(summary.entered.size(), world.rooms.size());
  EXPECT_NEAR(static_cast<double>(steps - 1) / simulation.rate_hz, summary.duration_s, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    Shipped, ExploredWorlds,
    testing::Combine(testing::Values("two_rooms", "eight_rooms", "nine_rooms", "identical_rooms",
                                     "slanted_and_curved", "open_hall"),
                     testing::Values(SensorKind::sonar, SensorKind::laser), testing::Values(11U)),
    [](const auto& shown) {
      return std::get<0>(shown.param) +
             (std::get<1>(shown.param) == SensorKind::sonar ? "Sonar" : "Laser");
    });

// With this seed the robot drives so far into a corner of a room that it cannot turn there.
INSTANTIATE_TEST_SUITE_P(Cornered, ExploredWorlds,
                         testing::Values(Case{"nine_rooms", SensorKind::sonar, 17U}));

}  // namespace
}  // namespace roomatlas
