// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/wall_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../../src/evaluate/segment_index.hpp"

#include "evaluate/four_rooms.hpp"

namespace roomatlas {
namespace {

using namespace test;

constexpr double kTiny_m = 1e-6;

WallErrors wall_errors_of(const FloorPlan& plan, const FloorPlan& truth = four_rooms(),
                          const Pose2& truth_from_building = {}) {
  const PlanErrors errors = plan_errors(plan, truth, truth_from_building, {}, {});
  return wall_errors(plan, truth, truth_from_building, errors, {});
}

TEST(SegmentIndex, FindsTheNearestEdgeHoweverFarItIs) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> at(-30.0, 30.0);
  std::vector<Ring> rings;
  for (const double away_m : {0.0, 20000.0, 1e6}) {
    for (int i = 0; i < 40; ++i) {
      Ring ring;
      for (int k = 0; k < 4; ++k) ring.push_back(Point2(away_m + at(random), at(random)));
      rings.push_back(ring);
    }
  }
  rings.push_back({{-1e5, -1e5}, {1e5, 0.5e5}, {-1e5, 1e5}});  // edges of 200 km
  const SegmentIndex index(rings);
  for (const double away_m : {0.0, 9999.0, 20000.0, 5e5}) {
    for (int i = 0; i < 50; ++i) {
      const Point2 point(away_m + at(random), at(random));
      double nearest_m = 1e300;
      for (const Ring& ring : rings) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
          nearest_m = std::min(nearest_m, distance({ring[k], ring[(k + 1) % ring.size()]}, point));
        }
      }
      EXPECT_NEAR(index.distance(point), nearest_m, 1e-9);
    }
  }
  EXPECT_EQ(SegmentIndex({}).distance({1.0, 2.0}), std::numeric_limits<double>::infinity());
}

TEST(WallErrors, OfThePerfectPlanAreNone) {
  const Pose2 truth_from_building{4, -2, radians(30)};
  const WallErrors errors = wall_errors_of(moved(inverse(truth_from_building), four_rooms()),
                                           four_rooms(), truth_from_building);
  EXPECT_NEAR(errors.plan_to_truth.median_m, 0.0, kTiny_m);
  EXPECT_NEAR(errors.plan_to_truth.percentile_95_m, 0.0, kTiny_m);
  EXPECT_NEAR(errors.truth_to_plan.percentile_95_m, 0.0, kTiny_m);
  EXPECT_EQ(errors.corners, 16);
  EXPECT_EQ(errors.corner_score.f1, 1.0);
  EXPECT_EQ(errors.angle_score.f1, 1.0);
  EXPECT_EQ(errors.areas.size(), 4U);
  EXPECT_NEAR(errors.mean_area_error, 0.0, kTiny_m);
  EXPECT_NEAR(errors.stretch.x, 1.0, kTiny_m);
  EXPECT_NEAR(errors.stretch.y, 1.0, kTiny_m);
  EXPECT_FALSE(errors.stretch.of_doors);
}

TEST(WallErrors, SamplesWallsAndNotDoors) {
  FloorPlan plan;
  plan.rooms = {room(1, {rectangle(0, 0, 4, 3)})};
  EXPECT_EQ(wall_errors_of(plan, plan).plan_to_truth.samples, 280);  // 14 m, each 0.05 m
  plan.doors = {door(1, {{1, 3.1}, {2, 3.1}}, 1, 1)};
  EXPECT_EQ(wall_errors_of(plan, plan).plan_to_truth.samples, 260);
}

TEST(WallErrors, AShiftedWallIsAsFarAsItWasShifted) {
  FloorPlan truth;
  truth.rooms = {room(1, {rectangle(0, 0, 10, 10)})};
  FloorPlan plan;
  plan.rooms = {room(1, {rectangle(0, 0, 10.2, 10)})};
  const WallErrors errors = wall_errors_of(plan, truth);
  EXPECT_NEAR(errors.plan_to_truth.median_m, 0.0, kTiny_m);  // three walls of four are right
  EXPECT_NEAR(errors.plan_to_truth.percentile_95_m, 0.2, kTiny_m);
  EXPECT_NEAR(errors.truth_to_plan.percentile_95_m, 0.2, kTiny_m);
  EXPECT_EQ(errors.corner_score.matched, 4);
  EXPECT_NEAR(errors.mean_area_error, 0.02, kTiny_m);
  EXPECT_NEAR(errors.stretch.x, 1.02, kTiny_m);
  EXPECT_NEAR(errors.stretch.y, 1.0, kTiny_m);
}

TEST(WallErrors, DistancesAgreeWithASearchOfAllEdges) {
  FloorPlan truth;
  truth.rooms = {room(1, {{{{0, 0}, {7, 1}, {5, 4}, {6, 9}, {-1, 5}}, {}}})};
  FloorPlan plan;
  plan.rooms = {room(1, {{{{0.3, 0}, {7.4, 1}, {5, 4.3}, {3, 8}, {-1, 5.5}}, {}}})};
  std::vector<double> all;
  const Ring& ours = plan.rooms[0].parts[0].outer;
  double next_m = 0.025;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const Point2 along = ours[(i + 1) % ours.size()] - ours[i];
    for (; next_m < along.norm(); next_m += 0.05) {
      all.push_back(distance_to_boundary(truth.rooms[0].parts[0].outer,
                                         ours[i] + next_m * along.normalized()));
    }
    next_m -= along.norm();
  }
  std::sort(all.begin(), all.end());
  const WallErrors errors = wall_errors_of(plan, truth);
  ASSERT_EQ(errors.plan_to_truth.samples, std::ssize(all));
  const auto rank = [&](double share) {
    return all[static_cast<std::size_t>(std::ceil(share * static_cast<double>(all.size()))) - 1];
  };
  EXPECT_NEAR(errors.plan_to_truth.median_m, rank(0.5), 1e-9);
  EXPECT_NEAR(errors.plan_to_truth.percentile_95_m, rank(0.95), 1e-9);
}

TEST(WallErrors, ACornerBeyondTheGateIsMissedAndATurnedOneHasAnotherAngle) {
  FloorPlan plan = four_rooms();
  plan.rooms[2] = room(3, {{{{7.4, 0}, {12.4, 0}, {12.4, 3}, {7.9, 3}}, {}}});  // 0.5 m off
  WallErrors errors = wall_errors_of(plan);
  EXPECT_EQ(errors.corner_score.matched, 15);
  EXPECT_NEAR(errors.corner_score.recall, 15.0 / 16.0, kTiny_m);
  EXPECT_EQ(errors.angle_score.matched, 15);  // the wall turned by 9.5 degrees alone
  plan.rooms[2] = room(3, {{{{7.4, 0}, {12.4, 0}, {12.4, 3}, {8.4, 3}}, {}}});  // 18.4 degrees
  errors = wall_errors_of(plan);
  EXPECT_EQ(errors.corner_score.matched, 15);
  EXPECT_EQ(errors.angle_score.matched, 14);
}

TEST(WallErrors, StairsOfPixelsAreNoCorners) {
  FloorPlan truth;
  truth.rooms = {room(1, {rectangle(0, 0, 4, 3)})};
  Ring stairs = {{0, 0}, {4, 0}, {4, 3}};
  for (int i = 0; i < 20; ++i) {
    stairs.emplace_back(4 - 0.2 * i, 3 + 0.05 * (i % 2));
    stairs.emplace_back(4 - 0.2 * (i + 1), 3 + 0.05 * (i % 2));
  }
  FloorPlan plan;
  plan.rooms = {room(1, {{stairs, {}}})};
  EXPECT_EQ(wall_errors_of(plan, truth).corners, 4);
}

TEST(WallErrors, StretchIsTakenFromDoorsWhereCornersAreTooFew) {
  FloorPlan truth = four_rooms();
  FloorPlan plan = four_rooms();
  for (PlanDoor& d : plan.doors) {
    d.jambs.a.x() *= 1.01;
    d.jambs.b.x() *= 1.01;
  }
  for (PlanRoom& r : plan.rooms) {
    for (Point2& p : r.parts[0].outer) p += Point2(0.0, 0.4);  // no corner within 0.3 m
  }
  const WallErrors errors = wall_errors_of(plan, truth);
  EXPECT_TRUE(errors.stretch.of_doors);
  EXPECT_EQ(errors.stretch.pairs, 5);
  EXPECT_NEAR(errors.stretch.x, 1.01, kTiny_m);
}

TEST(WallErrors, OfAnEmptyPlanAreNaN) {
  const WallErrors errors = wall_errors_of({});
  EXPECT_TRUE(std::isnan(errors.plan_to_truth.median_m));
  EXPECT_TRUE(std::isnan(errors.truth_to_plan.median_m));
  EXPECT_EQ(errors.corner_score.recall, 0.0);
  EXPECT_TRUE(std::isnan(errors.stretch.x));
}

}  // namespace
}  // namespace roomatlas
