// SPDX-License-Identifier: GPL-3.0-or-later
// One mission laid on another whose frame lies elsewhere.
#include "roomatlas/changes/lay_on.hpp"

#include <gtest/gtest.h>

#include "two_rooms.hpp"

namespace roomatlas {
namespace {

/// The mission in a frame that lies at `world_from_frame`.
void reframe(test::KnownMission& known, const Pose2& world_from_frame) {
  for (auto& [id, pose] : known.mission.placement) pose = inverse(world_from_frame) * pose;
  known.mission.plan = moved(known.mission.plan, inverse(world_from_frame));
}

test::WorldDrawing furnished_rooms() {
  return test::with_block(test::with_block(test::empty_rooms(), 7, 6, 3, 2), 28, 2, 2, 3);
}

TEST(LayOn, FindsWhereTheOtherFrameLies) {
  test::KnownMission before;
  test::KnownMission after;
  test::drive(before, furnished_rooms(), {test::kFirstRoom, test::kSecondRoom});
  test::drive(after, test::with_block(furnished_rooms(), 7, 6, 3, 2, ' '),
              {test::kSecondRoom, {{1.2, 3.3}, {1.2, 0.9}, {4.2, 0.9}}});
  const Pose2 truth{1.3, -0.8, radians(9.0)};
  reframe(after, truth);
  const std::optional<LaidOn> laid = lay_on(before.mission, after.mission, {Pose2{}}, {});
  ASSERT_TRUE(laid);
  EXPECT_LT((laid->old_from_new.position() - truth.position()).norm(), 0.05);
  EXPECT_NEAR(wrap_angle(laid->old_from_new.theta_rad - truth.theta_rad), 0.0, radians(0.5));
  EXPECT_GT(laid->agreement, 0.8);
  for (const auto& [id, pose] : laid->placement) {
    EXPECT_LT(pose.position().norm(), 0.05) << id;  // all were driven in the world's frame
    EXPECT_NEAR(pose.theta_rad, 0.0, radians(0.5)) << id;
  }
}

TEST(LayOn, AxesMayBeAQuarterTurnApart) {
  test::KnownMission before;
  test::KnownMission after;
  test::drive(before, furnished_rooms(), {test::kFirstRoom, test::kSecondRoom});
  test::drive(after, furnished_rooms(), {test::kFirstRoom, test::kSecondRoom});
  const Pose2 truth{0.2, 0.3, radians(-89.0)};
  reframe(after, truth);
  EXPECT_FALSE(lay_on(before.mission, after.mission, {Pose2{}}, {}));
  const std::optional<LaidOn> laid = lay_on(before.mission, after.mission, quarter_turns(), {});
  ASSERT_TRUE(laid);
  EXPECT_LT((laid->old_from_new.position() - truth.position()).norm(), 0.05);
  EXPECT_NEAR(wrap_angle(laid->old_from_new.theta_rad - truth.theta_rad), 0.0, radians(0.5));
}

TEST(LayOn, RoomsFarFromEachOtherHaveNothingInCommon) {
  test::KnownMission before;
  test::KnownMission after;
  test::drive(before, furnished_rooms(), {test::kFirstRoom, test::kSecondRoom});
  test::drive(after, furnished_rooms(), {test::kFirstRoom, test::kSecondRoom});
  reframe(after, {30.0, 0.0, 0.0});
  EXPECT_FALSE(lay_on(before.mission, after.mission, {Pose2{}}, {}));
}

TEST(LayOn, AVisitThatLiesALittleOffIsSettled) {
  test::KnownMission before;
  test::KnownMission after;
  test::drive(before, furnished_rooms(), {test::kFirstRoom, test::kSecondRoom});
  test::drive(after, furnished_rooms(), {test::kFirstRoom, test::kSecondRoom});
  after.mission.placement.at(2) = {0.08, -0.06, radians(0.6)};
  const std::optional<LaidOn> laid = lay_on(before.mission, after.mission, {Pose2{}}, {});
  ASSERT_TRUE(laid);
  EXPECT_LT(laid->placement.at(2).position().norm(), 0.04);
}

TEST(LayOn, AVisitThatContradictsTheOldMapEverywhereIsLeftOut) {
  test::KnownMission before;
  test::KnownMission after;
  test::drive(before, furnished_rooms(), {test::kFirstRoom, test::kSecondRoom});
  test::drive(after, furnished_rooms(), {test::kFirstRoom, test::kSecondRoom});
  after.mission.placement.at(2) = {1.2, 0.9, radians(15.0)};  // torn from where it belongs
  const std::optional<LaidOn> laid = lay_on(before.mission, after.mission, {Pose2{}}, {});
  ASSERT_TRUE(laid);
  EXPECT_TRUE(laid->placement.contains(1));
  EXPECT_FALSE(laid->placement.contains(2));
}

TEST(LayOn, SonarsAreLaidWhereTheyAreSaidToLie) {
  test::KnownMission before;
  test::KnownMission after;
  test::drive(before, furnished_rooms(), {test::kFirstRoom});
  test::drive(after, furnished_rooms(), {test::kFirstRoom});
  auto sonars = std::make_shared<RangeSensor>(*after.store.asrs.front().readings.front().sensor);
  sonars->kind = SensorKind::sonar;
  for (RangeReading& reading : after.store.asrs.front().readings) reading.sensor = sonars;
  const Pose2 said{1.0, 2.0, 0.3};
  const std::optional<LaidOn> laid = lay_on(before.mission, after.mission, {said}, {});
  ASSERT_TRUE(laid);
  EXPECT_EQ(laid->placement.at(1), said);
  EXPECT_FALSE(lay_on(before.mission, after.mission, quarter_turns(), {}));
}

TEST(MovedPlan, ThereAndBackIsTheSame) {
  FloorPlan plan = test::plan_of_rooms();
  plan.doors[0].leaf = Segment2{{5.0, 1.5}, {5.8, 1.6}};
  plan.edges = {{1, {{0.3, 0.3}, {4.8, 0.3}}, WallEvidence::measured, {}}};
  const Pose2 there{3.0, -2.0, 0.7};
  const FloorPlan moved_plan = moved(plan, there);
  EXPECT_LT((moved_plan.doors[0].leaf->b - there * Point2(5.8, 1.6)).norm(), 1e-12);
  const FloorPlan back = moved(moved_plan, inverse(there));
  EXPECT_LT((back.rooms[1].parts[0].outer[2] - plan.rooms[1].parts[0].outer[2]).norm(), 1e-9);
  EXPECT_LT((back.rooms[0].label_point - plan.rooms[0].label_point).norm(), 1e-9);
  EXPECT_LT((back.walls[3].outer[1] - plan.walls[3].outer[1]).norm(), 1e-9);
  EXPECT_LT((back.edges[0].line.b - plan.edges[0].line.b).norm(), 1e-9);
}

}  // namespace
}  // namespace roomatlas
