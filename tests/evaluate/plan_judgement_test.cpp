// SPDX-License-Identifier: GPL-3.0-or-later
// Each known defect of a plan moves exactly the numbers that it should.
#include <gtest/gtest.h>

#include <cmath>

#include "evaluate/four_rooms.hpp"
#include "roomatlas/evaluate/plan_errors.hpp"

namespace roomatlas {
namespace {

using namespace test;

constexpr double kTiny = 1e-6;
constexpr double kTrueArea = 12.0 + 9.0 + 15.0 + 12.4 * 1.8;

PlanErrors errors_of(const FloorPlan& plan) {
  return plan_errors(plan, four_rooms(), Pose2{}, {}, {});
}

/// What a perfect plan scores; a test changes what its defect moves.
PlanErrors perfect() { return errors_of(four_rooms()); }

void expect_rooms(const PlanErrors& errors, const PlanErrors& wanted) {
  EXPECT_NEAR(errors.precision, wanted.precision, kTiny);
  EXPECT_NEAR(errors.recall, wanted.recall, kTiny);
  EXPECT_NEAR(errors.f1, wanted.f1, kTiny);
  EXPECT_NEAR(errors.strict.precision, wanted.strict.precision, kTiny);
  EXPECT_NEAR(errors.strict.recall, wanted.strict.recall, kTiny);
  EXPECT_NEAR(errors.mean_iou, wanted.mean_iou, kTiny);
  EXPECT_NEAR(errors.mean_true_iou, wanted.mean_true_iou, kTiny);
}

void expect_segmentation(const Segmentation& found, const Segmentation& wanted) {
  EXPECT_NEAR(found.area_recall, wanted.area_recall, kTiny);
  EXPECT_NEAR(found.area_precision, wanted.area_precision, kTiny);
  EXPECT_NEAR(found.matthews, wanted.matthews, kTiny);
  EXPECT_NEAR(found.unlabelled, wanted.unlabelled, kTiny);
  EXPECT_NEAR(found.invented, wanted.invented, kTiny);
  EXPECT_NEAR(found.over_segmentation, wanted.over_segmentation, kTiny);
  EXPECT_NEAR(found.under_segmentation, wanted.under_segmentation, kTiny);
  EXPECT_EQ(found.split_true_rooms, wanted.split_true_rooms);
  EXPECT_EQ(found.merged_rooms, wanted.merged_rooms);
}

void expect_doors(const PlanErrors& errors, const PlanErrors& wanted) {
  EXPECT_EQ(errors.door_score.matched, wanted.door_score.matched);
  EXPECT_NEAR(errors.door_score.precision, wanted.door_score.precision, kTiny);
  EXPECT_NEAR(errors.door_score.recall, wanted.door_score.recall, kTiny);
  EXPECT_NEAR(errors.mean_door_distance_m, wanted.mean_door_distance_m, kTiny);
  EXPECT_NEAR(errors.mean_door_width_error_m, wanted.mean_door_width_error_m, kTiny);
}

void expect_graph(const PlanGraphErrors& found, const PlanGraphErrors& wanted) {
  EXPECT_EQ(found.edges, wanted.edges);
  EXPECT_EQ(found.isomorphic, wanted.isomorphic);
  EXPECT_EQ(found.as_matched, wanted.as_matched);
  EXPECT_EQ(found.missing, wanted.missing);
  EXPECT_EQ(found.extra, wanted.extra);
  EXPECT_EQ(found.wrong, wanted.wrong);
}

void expect_equal(const PlanErrors& errors, const PlanErrors& wanted) {
  expect_rooms(errors, wanted);
  expect_segmentation(errors.segmentation, wanted.segmentation);
  expect_doors(errors, wanted);
  ASSERT_TRUE(errors.graph && wanted.graph);
  expect_graph(*errors.graph, *wanted.graph);
}

/// Matthews correlation, literally, of areas.
double matthews(double both, double found_only, double true_only, double all) {
  const double neither = all - both - found_only - true_only;
  return (both * neither - found_only * true_only) /
         std::sqrt((both + found_only) * (both + true_only) * (neither + found_only) *
                   (neither + true_only));
}

TEST(PlanJudgement, APerfectPlanScoresOneInEverything) {
  const PlanErrors errors = perfect();
  for (const double one :
       {errors.precision, errors.recall, errors.f1, errors.strict.f1, errors.mean_iou,
        errors.mean_true_iou, errors.segmentation.area_recall, errors.segmentation.area_precision,
        errors.segmentation.matthews, errors.door_score.precision, errors.door_score.recall}) {
    EXPECT_NEAR(one, 1.0, kTiny);
  }
  for (const double none : {errors.segmentation.unlabelled, errors.segmentation.invented,
                            errors.segmentation.over_segmentation,
                            errors.segmentation.under_segmentation, errors.mean_door_distance_m}) {
    EXPECT_NEAR(none, 0.0, kTiny);
  }
  EXPECT_TRUE(errors.segmentation.split_true_rooms.empty());
  EXPECT_TRUE(errors.segmentation.merged_rooms.empty());
  ASSERT_TRUE(errors.graph);
  EXPECT_EQ(errors.graph->edges, 5);
  EXPECT_TRUE(errors.graph->isomorphic);
  EXPECT_TRUE(errors.graph->as_matched);
  EXPECT_EQ(errors.graph->edits(), 0);
}

TEST(PlanJudgement, TwoRoomsMergedLowerTheRoomsAndRaiseUnderSegmentation) {
  FloorPlan plan = four_rooms();  // rooms 1 and 2 and the wall between them
  plan.rooms[0] = room(1, {rectangle(0, 0, 7.2, 3)});
  plan.rooms.erase(plan.rooms.begin() + 1);
  plan.doors.pop_back();  // the door between the two is gone; door 3 now leads to room 1
  plan.doors[2].room_a = 1;
  PlanErrors wanted = perfect();
  const double iou = 12.0 / 21.6;
  wanted.precision = 1.0;
  wanted.recall = 3.0 / 4.0;
  wanted.f1 = 6.0 / 7.0;
  wanted.strict = {2, 2.0 / 3.0, 2.0 / 4.0, 4.0 / 7.0};
  wanted.mean_iou = (2.0 + iou) / 3.0;
  wanted.mean_true_iou = (2.0 + iou) / 4.0;
  wanted.segmentation.area_precision = (2.0 + iou) / 3.0;
  const double all = kTrueArea + 0.6;
  wanted.segmentation.matthews = (2.0 + matthews(12.0, 9.6, 0.0, all)) / 4.0;
  wanted.segmentation.invented = 0.6 / all;
  wanted.segmentation.under_segmentation = 9.0 / kTrueArea;
  wanted.segmentation.merged_rooms = {1};
  wanted.door_score = {4, 1.0, 4.0 / 5.0, 8.0 / 9.0};
  wanted.graph = {4, 5, false, false, 2, 1, 0};  // 1-2 and 2-4 are gone, a third door joins 1 and 4
  expect_equal(errors_of(plan), wanted);
}

TEST(PlanJudgement, ASplitRoomLowersPrecisionAndRaisesOverSegmentation) {
  FloorPlan plan = four_rooms();
  plan.rooms[2] = room(3, {rectangle(7.4, 0, 11.4, 3)});
  plan.rooms.push_back(room(5, {rectangle(11.4, 0, 12.4, 3)}));
  PlanErrors wanted = perfect();
  wanted.precision = 4.0 / 5.0;
  wanted.f1 = 8.0 / 9.0;
  wanted.strict.precision = 4.0 / 5.0;
  wanted.mean_iou = wanted.mean_true_iou = (3.0 + 0.8) / 4.0;
  wanted.segmentation.area_recall = (3.0 + 0.8) / 4.0;
  wanted.segmentation.matthews = (3.0 + matthews(12.0, 0.0, 3.0, kTrueArea)) / 4.0;
  wanted.segmentation.over_segmentation = 3.0 / kTrueArea;
  wanted.segmentation.split_true_rooms = {3};
  wanted.graph->as_matched = false;  // a room too many; the edges are right
  wanted.graph->isomorphic = false;
  expect_equal(errors_of(plan), wanted);
}

TEST(PlanJudgement, ARoomShiftedBy03mLowersItsOverlapAlone) {
  FloorPlan plan = four_rooms();
  plan.rooms[2] = room(3, {rectangle(7.4, -0.3, 12.4, 2.7)});
  PlanErrors wanted = perfect();
  wanted.mean_iou = wanted.mean_true_iou = (3.0 + 13.5 / 16.5) / 4.0;
  wanted.segmentation.area_recall = wanted.segmentation.area_precision = (3.0 + 0.9) / 4.0;
  wanted.segmentation.matthews = (3.0 + matthews(13.5, 1.5, 1.5, kTrueArea + 1.5)) / 4.0;
  wanted.segmentation.unlabelled = 1.5 / kTrueArea;
  wanted.segmentation.invented = 1.5 / kTrueArea;
  expect_equal(errors_of(plan), wanted);
}

TEST(PlanJudgement, AMissingDoorLowersDoorRecallAndTheGraphAlone) {
  FloorPlan plan = four_rooms();
  plan.doors.erase(plan.doors.begin() + 3);
  PlanErrors wanted = perfect();
  wanted.door_score = {4, 1.0, 4.0 / 5.0, 8.0 / 9.0};
  wanted.graph = {4, 5, false, false, 1, 0, 0};
  expect_equal(errors_of(plan), wanted);
}

TEST(PlanJudgement, OneOfTwoDoorsBetweenTheSameRoomsIsAMissingEdge) {
  FloorPlan plan = four_rooms();
  plan.doors.erase(plan.doors.begin());
  const PlanErrors errors = errors_of(plan);
  EXPECT_EQ(errors.graph->missing, 1);
  EXPECT_FALSE(errors.graph->isomorphic);
}

TEST(PlanJudgement, AMovedDoorCountsWithItsDistance) {
  FloorPlan plan = four_rooms();
  plan.doors[3].jambs = {{9.2, 3.1}, {10.1, 3.1}};
  PlanErrors wanted = perfect();
  wanted.mean_door_distance_m = 0.2 / 5.0;
  expect_equal(errors_of(plan), wanted);
}

TEST(PlanJudgement, ADoorDrawnTooWideOrTooNarrowCountsWithTheDifferenceOfItsWidth) {
  FloorPlan plan = four_rooms();
  plan.doors[0].jambs = {{0.4, 3.1}, {1.5, 3.1}};    // 1.1 m for 0.9 m, about the same middle
  plan.doors[2].jambs = {{5.75, 3.1}, {5.15, 3.1}};  // 0.6 m, from the other jamb
  PlanErrors wanted = perfect();
  wanted.mean_door_width_error_m = (0.2 + 0.3) / 5.0;
  const PlanErrors errors = errors_of(plan);
  expect_equal(errors, wanted);
  for (const DoorMatch& match : errors.door_matches) {
    const double wanted_m = match.door == 1 ? 0.2 : match.door == 3 ? -0.3 : 0.0;
    EXPECT_NEAR(match.width_error_m, wanted_m, kTiny) << match.door;
  }
}

TEST(PlanJudgement, ADoorWithoutAPairHasNoWidthError) {
  FloorPlan plan = four_rooms();
  plan.doors[4].jambs = {{4.1, 2.2}, {4.1, 2.9}};  // 1.1 m off, and too narrow
  EXPECT_NEAR(errors_of(plan).mean_door_width_error_m, 0.0, kTiny);
  plan.doors.clear();
  EXPECT_TRUE(std::isnan(errors_of(plan).mean_door_width_error_m));
}

TEST(PlanJudgement, AnInventedDoorIsAnExtraOrAWrongEdge) {
  FloorPlan plan = four_rooms();
  plan.doors.push_back(door(6, {{11, 3.1}, {11.9, 3.1}}, 3, 4));  // a second one
  EXPECT_EQ(errors_of(plan).graph->extra, 1);
  plan.doors.back() = door(6, {{7.3, 1}, {7.3, 1.9}}, 2, 3);  // truth joins 2 and 3 nowhere
  const PlanErrors errors = errors_of(plan);
  EXPECT_EQ(errors.graph->extra, 0);
  EXPECT_EQ(errors.graph->wrong, 1);
  EXPECT_NEAR(errors.door_score.precision, 5.0 / 6.0, kTiny);
}

TEST(PlanJudgement, RoomsThatSwappedTheirDoorsAreIsomorphicButNotAsMatched) {
  FloorPlan plan = four_rooms();  // rooms 1 and 2 change parts: two doors lead from 2 to 4
  plan.doors[1].room_a = 2;
  const PlanErrors errors = errors_of(plan);
  EXPECT_TRUE(errors.graph->isomorphic);
  EXPECT_FALSE(errors.graph->as_matched);
  EXPECT_EQ(errors.graph->missing, 1);
  EXPECT_EQ(errors.graph->extra, 1);
}

TEST(PlanJudgement, GraphsWithEqualDegreesNeedNotBeIsomorphic) {
  // Six rooms with two doors each: in one ring, or in two. Refinement cannot tell them apart.
  const auto ring_plan = [](const std::vector<std::pair<RoomId, RoomId>>& doors) {
    FloorPlan plan;
    for (RoomId id = 1; id <= 6; ++id) {
      const double x = static_cast<double>(10 * id);
      plan.rooms.push_back(room(id, {rectangle(x, 0, x + 5, 5)}));
    }
    for (const auto& [a, b] : doors) {
      plan.doors.push_back(door(std::ssize(plan.doors) + 1, {}, a, b));
    }
    return plan;
  };
  const FloorPlan one = ring_plan({{1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {1, 6}});
  const FloorPlan other = ring_plan({{1, 3}, {3, 5}, {2, 5}, {2, 4}, {4, 6}, {1, 6}});
  const FloorPlan two = ring_plan({{1, 2}, {2, 3}, {1, 3}, {4, 5}, {5, 6}, {4, 6}});
  EXPECT_TRUE(plan_graph_errors(one, other, {}).isomorphic);
  EXPECT_FALSE(plan_graph_errors(one, two, {}).isomorphic);
}

TEST(PlanJudgement, ManyRoomsAlongOneCorridorAreComparedQuickly) {
  const auto comb = [](int rooms, RoomId corridor, bool with_a_wrong_door) {
    FloorPlan plan;
    for (RoomId id = 1; id <= rooms; ++id) plan.rooms.push_back(room(id, {}));
    for (RoomId id = 1; id <= rooms; ++id) {
      if (id != corridor) plan.doors.push_back(door(id, {}, id, corridor));
    }
    if (with_a_wrong_door) plan.doors.back().room_b = corridor == 1 ? 2 : 1;
    return plan;
  };
  EXPECT_TRUE(plan_graph_errors(comb(60, 1, false), comb(60, 30, false), {}).isomorphic);
  EXPECT_FALSE(plan_graph_errors(comb(60, 1, false), comb(60, 30, true), {}).isomorphic);
}

TEST(PlanJudgement, ATruthWithoutDoorsLeavesDoorsUnmeasured) {
  FloorPlan truth = four_rooms();
  truth.doors.clear();
  const PlanErrors errors = plan_errors(four_rooms(), truth, Pose2{}, {}, {.doors_known = false});
  EXPECT_FALSE(errors.doors_known);
  EXPECT_FALSE(errors.graph);
  EXPECT_NEAR(errors.f1, 1.0, kTiny);
}

TEST(PlanJudgement, AnEmptyPlanScoresNothing) {
  const PlanErrors errors = errors_of({});
  EXPECT_EQ(errors.f1, 0.0);
  EXPECT_EQ(errors.segmentation.matthews, 0.0);
  EXPECT_EQ(errors.segmentation.unlabelled, 1.0);
  EXPECT_EQ(errors.segmentation.area_recall, 0.0);
  EXPECT_EQ(errors.door_score.recall, 0.0);
  EXPECT_EQ(errors.graph->missing, 5);
}

TEST(PlanJudgement, MatchesAsManyRoomsAsReachTheThreshold) {
  // One found room takes most of true room 1 and a part of room 2, another a part of room 1: the
  // greatest sum of overlaps would cross the pairs and lose the one that is right.
  FloorPlan truth;
  truth.rooms = {room(1, {rectangle(0, 0, 16, 10)}), room(2, {rectangle(16, 0, 21, 10)})};
  FloorPlan plan;
  plan.rooms = {room(1, {rectangle(5, 0, 21, 10)}), room(2, {rectangle(0, 0, 5, 10)})};
  const PlanErrors errors = plan_errors(plan, truth, Pose2{}, {}, {});
  ASSERT_EQ(errors.room_matches.size(), 1U);
  EXPECT_EQ(errors.room_matches[0].room, 1);
  EXPECT_EQ(errors.room_matches[0].true_room, 1);
  EXPECT_NEAR(errors.room_matches[0].iou, 11.0 / 21.0, kTiny);
}

}  // namespace
}  // namespace roomatlas
