// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "roomatlas/evaluate/evaluate.hpp"

namespace roomatlas {
namespace {

constexpr double kTinyShare = 1e-6;  // square metres, or a share of one

Polygon rectangle_of(double left, double bottom, double right, double top) {
  return {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, {}};
}

PlanRoom room(RoomId id, std::vector<Polygon> parts) {
  PlanRoom made;
  made.id = id;
  made.parts = std::move(parts);
  return made;
}

PlanDoor door_between(std::int64_t id, const Segment2& jambs) {
  PlanDoor made;
  made.id = id;
  made.jambs = jambs;
  return made;
}

/// Two rooms of 4 m x 3 m side by side, and a corridor of 8.2 m x 1.8 m above both.
///     +---------------------+
///     |          3          |
///     +---[2]---+---[3]-----+
///     |    1   [1]    2     |
///     +---------+-----------+
FloorPlan true_plan() {
  FloorPlan plan;
  plan.rooms = {room(1, {rectangle_of(0, 0, 4, 3)}), room(2, {rectangle_of(4.2, 0, 8.2, 3)}),
                room(3, {rectangle_of(0, 3.2, 8.2, 5)})};
  plan.doors = {door_between(1, {{4.1, 1}, {4.1, 2}}), door_between(2, {{1, 3.1}, {2, 3.1}}),
                door_between(3, {{6, 3.1}, {7, 3.1}})};
  return plan;
}

/// From room 1 through door 1 into room 2 and through door 3 into the corridor.
Trajectory true_path() {
  return {{0, {2, 1.5, 0}}, {1, {6.5, 1.5, 0}}, {2, {6.5, 1.5, kPi / 2}}, {3, {6.5, 4, kPi / 2}}};
}

PlanErrors errors_in(const FloorPlan& plan) {
  return plan_errors(plan, true_plan(), Pose2{}, true_path(), {});
}

std::vector<std::int64_t> matched_true_doors(const PlanErrors& errors) {
  std::vector<std::int64_t> ids;
  for (const DoorMatch& match : errors.door_matches) ids.push_back(match.true_door);
  std::sort(ids.begin(), ids.end());
  return ids;
}

TEST(PlanErrors, OfThePerfectPlanAreNone) {
  const PlanErrors errors = errors_in(true_plan());
  EXPECT_EQ(errors.rooms, 3);
  EXPECT_EQ(errors.true_rooms, 3);
  EXPECT_DOUBLE_EQ(errors.precision, 1.0);
  EXPECT_DOUBLE_EQ(errors.recall, 1.0);
  EXPECT_DOUBLE_EQ(errors.f1, 1.0);
  EXPECT_NEAR(errors.mean_iou, 1.0, kTinyShare);
  ASSERT_EQ(errors.room_matches.size(), 3U);
  for (const RoomMatch& match : errors.room_matches) EXPECT_EQ(match.room, match.true_room);
  ASSERT_EQ(errors.door_matches.size(), 3U);
  for (const DoorMatch& match : errors.door_matches) EXPECT_EQ(match.door, match.true_door);
  EXPECT_EQ(errors.used_true_doors, (std::vector<std::int64_t>{1, 3}));
  EXPECT_TRUE(errors.missed_used_doors.empty());
}

TEST(PlanErrors, AreMeasuredInTheFrameOfTheTruth) {
  const Pose2 truth_from_building{10, -4, kPi / 2};
  const Pose2 building_from_truth = inverse(truth_from_building);
  FloorPlan plan = true_plan();
  for (PlanRoom& r : plan.rooms) r.parts[0] = transformed(building_from_truth, r.parts[0]);
  for (PlanDoor& d : plan.doors) d.jambs = transformed(building_from_truth, d.jambs);
  const PlanErrors errors = plan_errors(plan, true_plan(), truth_from_building, true_path(), {});
  EXPECT_DOUBLE_EQ(errors.f1, 1.0);
  EXPECT_NEAR(errors.mean_iou, 1.0, kTinyShare);
  EXPECT_EQ(errors.door_matches.size(), 3U);
  EXPECT_DOUBLE_EQ(errors_in(plan).f1, 0.0);  // without the alignment nothing fits
}

TEST(PlanErrors, TwoRoomsMergedIntoOneLowerPrecisionAndRecall) {
  FloorPlan plan = true_plan();
  plan.rooms = {room(1, {rectangle_of(0, 0, 8.2, 3)}), room(3, {rectangle_of(0, 3.2, 8.2, 5)})};
  const PlanErrors errors = errors_in(plan);  // the merged room has IoU 12 / 24.6 with each
  ASSERT_EQ(errors.room_matches.size(), 1U);
  EXPECT_EQ(errors.room_matches[0].true_room, 3);
  EXPECT_DOUBLE_EQ(errors.precision, 1.0 / 2.0);
  EXPECT_DOUBLE_EQ(errors.recall, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(errors.f1, 0.4);
  EXPECT_NEAR(errors.mean_iou, 1.0, kTinyShare);
}

TEST(PlanErrors, ASplitRoomLowersPrecisionAndTheLargerPieceMatches) {
  FloorPlan plan = true_plan();
  plan.rooms[2] = room(3, {rectangle_of(0, 3.2, 3, 5)});
  plan.rooms.push_back(room(4, {rectangle_of(3, 3.2, 8.2, 5)}));
  const PlanErrors errors = errors_in(plan);
  EXPECT_EQ(errors.rooms, 4);
  EXPECT_DOUBLE_EQ(errors.precision, 0.75);
  EXPECT_DOUBLE_EQ(errors.recall, 1.0);
  EXPECT_DOUBLE_EQ(errors.f1, 6.0 / 7.0);
  ASSERT_EQ(errors.room_matches.size(), 3U);
  EXPECT_EQ(errors.room_matches[2].room, 4);  // greatest IoU first
  EXPECT_NEAR(errors.room_matches[2].iou, 5.2 / 8.2, kTinyShare);
}

TEST(PlanErrors, ASlightlyShiftedRoomLowersTheMeanIoUAlone) {
  FloorPlan plan = true_plan();
  plan.rooms[0].parts[0] = rectangle_of(-0.4, 0, 3.6, 3);
  const PlanErrors errors = errors_in(plan);
  EXPECT_DOUBLE_EQ(errors.f1, 1.0);
  EXPECT_NEAR(errors.mean_iou, (1.0 + 1.0 + 10.8 / 13.2) / 3.0, kTinyShare);
  EXPECT_EQ(errors.door_matches.size(), 3U);
}

TEST(PlanErrors, AFarShiftedRoomIsNoMatch) {
  FloorPlan plan = true_plan();
  plan.rooms[0].parts[0] = rectangle_of(-2, 0, 2, 3);  // IoU 1/3
  EXPECT_DOUBLE_EQ(errors_in(plan).f1, 2.0 / 3.0);
  const PlanErrors lenient =
      plan_errors(plan, true_plan(), Pose2{}, true_path(), {.iou_threshold = 0.3});
  EXPECT_DOUBLE_EQ(lenient.f1, 1.0);
  EXPECT_NEAR(lenient.mean_iou, (1.0 + 1.0 + 1.0 / 3.0) / 3.0, kTinyShare);
}

TEST(PlanErrors, RoomsThatOverlapNothingNeverMatchEvenWithoutAThreshold) {
  FloorPlan plan;
  plan.rooms = {room(1, {rectangle_of(50, 50, 54, 53)}), room(2, {})};
  const PlanErrors errors =
      plan_errors(plan, true_plan(), Pose2{}, true_path(), {.iou_threshold = 0.0});
  EXPECT_TRUE(errors.room_matches.empty());
}

TEST(PlanErrors, ARoomOfSeveralPartsCountsAsAWhole) {
  FloorPlan plan = true_plan();
  plan.rooms[2].parts = {rectangle_of(4, 3.2, 8.2, 5), rectangle_of(0, 3.2, 4, 5)};
  EXPECT_NEAR(errors_in(plan).mean_iou, 1.0, kTinyShare);
}

TEST(PlanErrors, AMissingUsedDoorIsMissed) {
  FloorPlan plan = true_plan();
  plan.doors.erase(plan.doors.begin());
  const PlanErrors errors = errors_in(plan);
  EXPECT_EQ(matched_true_doors(errors), (std::vector<std::int64_t>{2, 3}));
  EXPECT_EQ(errors.used_true_doors, (std::vector<std::int64_t>{1, 3}));
  EXPECT_EQ(errors.missed_used_doors, (std::vector<std::int64_t>{1}));
  EXPECT_DOUBLE_EQ(errors.f1, 1.0);
}

TEST(PlanErrors, AMissingDoorThatNobodyUsedIsNotMissed) {
  FloorPlan plan = true_plan();
  plan.doors.erase(plan.doors.begin() + 1);
  const PlanErrors errors = errors_in(plan);
  EXPECT_EQ(matched_true_doors(errors), (std::vector<std::int64_t>{1, 3}));
  EXPECT_TRUE(errors.missed_used_doors.empty());
}

TEST(PlanErrors, DoorsMatchWithinTheGateOnly) {
  FloorPlan plan = true_plan();
  plan.doors[0].jambs = {{4.1, 1.4}, {4.1, 2.4}};
  plan.doors[2].jambs = {{6.6, 3.1}, {7.6, 3.1}};
  const PlanErrors errors = errors_in(plan);
  EXPECT_EQ(matched_true_doors(errors), (std::vector<std::int64_t>{1, 2}));
  EXPECT_NEAR(errors.door_matches.back().distance_m, 0.4, 1e-12);  // nearest first
  EXPECT_EQ(errors.missed_used_doors, (std::vector<std::int64_t>{3}));
}

TEST(PlanErrors, TheNearestOfTwoDoorsMatchesAndTheOtherDoesNot) {
  FloorPlan plan = true_plan();
  plan.doors.insert(plan.doors.begin(), door_between(9, {{4.1, 1.3}, {4.1, 2.3}}));
  const PlanErrors errors = errors_in(plan);
  ASSERT_EQ(errors.door_matches.size(), 3U);
  for (const DoorMatch& match : errors.door_matches) EXPECT_EQ(match.door, match.true_door);
}

TEST(PlanErrors, APathThatEndsBeforeADoorDoesNotUseIt) {
  const Trajectory path = {{0, {2, 1.5, 0}}, {1, {4.0, 1.5, 0}}, {2, {2, 1.5, 0}}};
  const PlanErrors errors = plan_errors(true_plan(), true_plan(), Pose2{}, path, {});
  EXPECT_TRUE(errors.used_true_doors.empty());
}

TEST(PlanErrors, OfEmptyPlansAreZeroAndFinite) {
  const FloorPlan nothing;
  for (const PlanErrors& errors :
       {plan_errors(nothing, nothing, Pose2{}, {}, {}), errors_in(nothing),
        plan_errors(true_plan(), nothing, Pose2{}, true_path(), {})}) {
    for (const double value : {errors.precision, errors.recall, errors.f1, errors.mean_iou}) {
      EXPECT_EQ(value, 0.0);
    }
    EXPECT_TRUE(errors.room_matches.empty());
    EXPECT_TRUE(errors.door_matches.empty());
  }
  EXPECT_EQ(errors_in(nothing).missed_used_doors, (std::vector<std::int64_t>{1, 3}));
}

}  // namespace
}  // namespace roomatlas
