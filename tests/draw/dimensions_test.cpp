// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/dimensions.hpp"

#include "../../src/draw/dimension_text.hpp"
#include "draw/flat_fixture.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace roomatlas {
namespace {

using test::flat;
using test::room;

TEST(MainDirection, IsThatOfMostWallsModuloARightAngle) {
  for (const double turn_deg : {-44.0, -10.0, 0.0, 0.5, 30.0, 44.9}) {
    for (const double quarter_deg : {0.0, 90.0, 180.0}) {
      const FloorPlan plan = test::moved(flat(), {3, 4, radians(turn_deg + quarter_deg)});
      EXPECT_NEAR(degrees(main_direction_rad(plan)), turn_deg, 1e-6);
    }
  }
}

TEST(MainDirection, IsNoneOfARoundBuildingAndOfNone) {
  FloorPlan round;
  round.rooms = {room(1, "1", RoomKind::hall, {{0, 0}, {1, 1}})};
  Ring& ring = round.rooms[0].parts[0].outer;
  ring.clear();
  for (int i = 0; i < 48; ++i) ring.push_back(5.0 * direction(2.0 * kPi * i / 48 + 0.3));
  EXPECT_EQ(main_direction_rad(round), 0.0);
  EXPECT_EQ(main_direction_rad({}), 0.0);
  EXPECT_TRUE(dimension_chains({}).empty());
}

TEST(MainBlock, LeavesAWingAtAnotherAngleOut) {
  FloorPlan plan = flat();
  FloorPlan wing;
  wing.rooms = {room(9, "9", RoomKind::room, {{0, 0}, {4, 3}})};
  wing = test::moved(wing, {7.5, 0.0, radians(30.0)});
  const auto before = dimension_chains(plan);
  plan.rooms.push_back(wing.rooms[0]);
  EXPECT_EQ(main_block(plan, 0.0).size(), 3U);
  const auto after = dimension_chains(plan);
  ASSERT_EQ(after.size(), before.size());
  EXPECT_EQ(after[0].stations_m, before[0].stations_m);
}

TEST(DimensionChains, RunFromOuterFaceToOuterFaceOverTheFacesOfWalls) {
  const auto chains = dimension_chains(flat());
  ASSERT_EQ(chains.size(), 2U);
  const auto near = [](std::vector<double> stations) {
    std::vector<testing::Matcher<double>> matchers;
    for (const double station : stations) matchers.push_back(testing::DoubleNear(station, 1e-9));
    return testing::ElementsAreArray(matchers);
  };
  EXPECT_THAT(chains[0].stations_m, near({0, 0.3, 3.873, 3.973, 6.514, 6.814}));
  EXPECT_THAT(chains[1].stations_m, near({0, 0.3, 3.3, 3.54, 6.0, 6.3}));
  EXPECT_LT((chains[0].along - Point2(1, 0)).norm(), 1e-12);
  EXPECT_LT((chains[1].outwards - Point2(-1, 0)).norm(), 1e-12);
}

TEST(DimensionChains, CountAStepOfTheOutlineButNotARoomBehindAnother) {
  FloorPlan plan;
  plan.rooms = {room(1, "1", RoomKind::room, {{0, 0}, {3, 4}}),
                room(2, "2", RoomKind::room, {{3.2, 1}, {7, 4}}),
                room(3, "3", RoomKind::room, {{1, 4.2}, {5, 9}})};
  EXPECT_THAT(dimension_chains(plan)[0].stations_m, testing::ElementsAre(0, 3, 3.2, 7));
}

TEST(DimensionChains, EndAtTheWallOfAnArcToo) {
  FloorPlan plan;
  plan.rooms = {room(1, "1", RoomKind::room, {{0, 0}, {6, 4}})};
  const auto with_arc = [](const Point2& low, const Point2& high) {  // above a rectangle
    Ring ring = {low, {high.x(), low.y()}};
    const double radius = (high.x() - low.x()) / 2.0;
    for (int i = 0; i <= 20; ++i) {
      ring.push_back(Point2(low.x() + radius, high.y()) + radius * direction(kPi * i / 20));
    }
    return ring;
  };
  plan.rooms[0].parts[0].outer = with_arc({0, 0}, {6, 4});
  plan.walls = {{with_arc({-0.2, -0.2}, {6.2, 4}), {plan.rooms[0].parts[0].outer}}};
  const auto chains = dimension_chains(plan);
  EXPECT_NEAR(chains[0].total_m(), 6.4, 1e-9);
  EXPECT_NEAR(chains[1].total_m(), 0.2 + 4.0 + 3.2, 1e-9);
}

TEST(Centimetres, AddUpForAnyChoiceOfStationsAndAreNeverOffByMoreThanOne) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> length_m(0.02, 3.0);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> stations = {0.0};
    for (int i = 0; i < 12; ++i) stations.push_back(stations.back() + length_m(random));
    const auto parts = centimetres(stations);
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      sum += parts[i];
      EXPECT_LE(std::abs(0.01 * double(parts[i]) - (stations[i + 1] - stations[i])), 0.01 + 1e-9);
    }
    EXPECT_EQ(sum, centimetres({stations.front(), stations.back()}).front());
  }
}

TEST(FittedChain, TextsNeverMeetAndNothingIsLostOfTheTotal) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> length_m(0.03, 1.5);
  for (const double mm_per_m : {20.0, 10.0, 4.0, 1.0}) {
    std::vector<double> stations = {0.0};
    for (int i = 0; i < 60; ++i) stations.push_back(stations.back() + length_m(random));
    const drawing::FittedChain fitted = drawing::fitted_chain(stations, mm_per_m);
    EXPECT_EQ(fitted.stations_m.front(), stations.front());
    EXPECT_EQ(fitted.stations_m.back(), stations.back());
    ASSERT_EQ(fitted.texts.size() + 1, fitted.stations_m.size());
    for (std::size_t i = 0; i < fitted.texts.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const auto& [a, b] = std::pair(fitted.texts[k], fitted.texts[i]);
        if (a.is_aside != b.is_aside) continue;
        EXPECT_GT(b.middle_mm - a.middle_mm, (a.width_mm + b.width_mm) / 2.0);
      }
    }
  }
}

TEST(ExtentOf, IsThatOfRectanglesAlongTheirOwnWalls) {
  const PlanRoom plain = room(1, "1", RoomKind::room, {{0, 0}, {4, 3}});
  FloorPlan turned;
  turned.rooms = {plain};
  turned = test::moved(turned, {1, 1, radians(30.0)});
  for (const PlanRoom& one : {plain, turned.rooms[0]}) {
    const auto extent = extent_of(one, 0.0);
    ASSERT_TRUE(extent);
    EXPECT_NEAR(extent->width_m, 4.0, 1e-9);
    EXPECT_NEAR(extent->depth_m, 3.0, 1e-9);
  }
  PlanRoom angled = plain;
  angled.parts[0].outer = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
  EXPECT_FALSE(extent_of(angled, 0.0));
}

}  // namespace
}  // namespace roomatlas
