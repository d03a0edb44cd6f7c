// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/plan_accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace roomatlas {
namespace {

FloorPlan building(double width_m) {
  FloorPlan plan;
  plan.rooms.resize(1);
  plan.rooms[0].parts = {{{{0, 0}, {width_m, 0}, {width_m, 5}, {0, 5}}, {}}};
  return plan;
}

TEST(PlanAccuracy, WithinARoomItIsTheScatterOfReadingsAboutTheMeasuredEdges) {
  std::mt19937 random(3);
  constexpr double kSigma_m = 0.02;
  std::normal_distribution<double> noise(0.0, kSigma_m);
  double mean_m = 0.0;  // of absolute deviations, as an edge has it
  constexpr int kReadings = 20000;
  for (int i = 0; i < kReadings; ++i) mean_m += std::abs(noise(random)) / kReadings;
  FloorPlan plan = building(10.0);
  plan.edges = {{1, {{0, 0}, {10, 0}}, WallEvidence::measured, mean_m},
                {1, {{10, 0}, {10, 5}}, WallEvidence::inferred, 0.9},
                {1, {{10, 5}, {0, 5}}, WallEvidence::measured, {}}};
  EXPECT_NEAR(plan_accuracy(plan, {}).within_room_m.value(), kSigma_m, 0.0005);
  plan.edges.clear();
  EXPECT_FALSE(plan_accuracy(plan, {}).within_room_m);
}

TEST(PlanAccuracy, OverTheBuildingIsTheScalesBarOfItsLongerSide) {
  Judgement judgement;
  judgement.probability = 0.8;
  judgement.place_m = 0.05;
  judgement.scale_share = 0.01;
  const PlanAccuracy accuracy = plan_accuracy(building(100.0), judgement);
  EXPECT_EQ(accuracy.extent_m, 100.0);
  EXPECT_NEAR(accuracy.over_building_m.value(), 1.0, 1e-12);
  EXPECT_EQ(accuracy.between_rooms_m, 0.05);
  EXPECT_EQ(accuracy.probability, 0.8);
  EXPECT_FALSE(plan_accuracy(building(100.0), {}).over_building_m);
}

TEST(PlanAccuracy, NothingIsSaidOfAnEmptyPlan) {
  const PlanAccuracy accuracy = plan_accuracy({}, Judgement{});
  EXPECT_FALSE(accuracy.within_room_m || accuracy.between_rooms_m || accuracy.over_building_m);
  EXPECT_EQ(accuracy.extent_m, 0.0);
}

}  // namespace
}  // namespace roomatlas
