// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "roomatlas/evaluate/room_pose_errors.hpp"

namespace roomatlas {
namespace {

/// Ten poses from time `start_s` on, along x from `x_m`.
Trajectory stretch(double start_s, double x_m) {
  Trajectory path;
  for (int i = 0; i < 10; ++i) path.push_back({start_s + i, {x_m + 0.3 * i, 1.0, 0.1 * i}});
  return path;
}

/// The truth of both visits below, one after the other.
Trajectory truth() {
  Trajectory all = stretch(0, 0);
  for (const StampedPose& pose : stretch(10, 5)) all.push_back(pose);
  return all;
}

/// A stretch of which every pose is moved by a motion of the world.
Trajectory moved_path(const Pose2& motion, Trajectory path) {
  for (StampedPose& pose : path) pose.pose = motion * pose.pose;
  return path;
}

constexpr double kNothing = 1e-9;

TEST(RoomPoseErrors, AreZeroWhereTheRobotWasWhereItIsPlaced) {
  const RoomPoseErrors errors =
      room_pose_errors({{1, 1, stretch(0, 0)}, {2, 2, stretch(10, 5)}}, truth(), Pose2{});
  ASSERT_EQ(errors.rooms.size(), 2U);
  EXPECT_NEAR(errors.rotation_deg.maximum, 0.0, 1e-6);
  EXPECT_NEAR(errors.translation_m.maximum, 0.0, kNothing);
  EXPECT_EQ(errors.rooms[0].poses, 10);
}

TEST(RoomPoseErrors, OfATurnedRoomAreItsTurnAndTheShiftOfItsMiddle) {
  // Turned about the first pose of its path: the middle, 1.35 m on, moves along a chord.
  const Pose2 pivot{5, 1, 0};
  const Pose2 turn = pivot * Pose2{0, 0, radians(10)} * inverse(pivot);
  const RoomPoseErrors errors = room_pose_errors(
      {{1, 1, stretch(0, 0)}, {2, 2, moved_path(turn, stretch(10, 5))}}, truth(), Pose2{});
  EXPECT_NEAR(degrees(errors.rooms[1].rotation_rad), 10.0, 1e-6);
  EXPECT_NEAR(errors.rooms[1].translation_m, 2 * 1.35 * std::sin(radians(5)), kNothing);
  EXPECT_NEAR(errors.rooms[0].rotation_rad, 0.0, kNothing);
  EXPECT_NEAR(errors.rotation_deg.mean, 5.0, 1e-6);
}

TEST(RoomPoseErrors, RelativeToTheFirstRoomDoNotDependOnWhereTheMapLies) {
  const Pose2 anywhere{40, -7, radians(120)};
  const RoomPoseErrors errors =
      room_pose_errors({{1, 1, moved_path(anywhere, stretch(0, 0))},
                        {2, 2, moved_path(anywhere * Pose2{0, 0.5, 0}, stretch(10, 5))}},
                       truth(), Pose2{});
  EXPECT_NEAR(errors.rooms[0].relative_translation_m, 0.0, kNothing);
  EXPECT_NEAR(errors.rooms[1].relative_translation_m, 0.5, kNothing);
  EXPECT_NEAR(errors.rooms[1].relative_rotation_rad, 0.0, kNothing);
  EXPECT_GT(errors.rooms[0].translation_m, 1.0);  // the alignment was not given
}

TEST(RoomPoseErrors, OfARoomWithTwoVisitsDoNotCancel) {
  const RoomPoseErrors errors = room_pose_errors({{1, 1, moved_path({0, 0.2, 0}, stretch(0, 0))},
                                                  {2, 1, moved_path({0, -0.2, 0}, stretch(10, 5))}},
                                                 truth(), Pose2{});
  ASSERT_EQ(errors.rooms.size(), 1U);
  EXPECT_EQ(errors.rooms[0].visits, 2);
  EXPECT_NEAR(errors.rooms[0].translation_m, 0.2, kNothing);
}

TEST(RoomPoseErrors, LeaveOutVisitsWithoutTruth) {
  const RoomPoseErrors errors =
      room_pose_errors({{1, 1, stretch(0, 0)}, {2, 2, stretch(500, 5)}}, truth(), Pose2{});
  EXPECT_EQ(errors.rooms.size(), 1U);
  EXPECT_TRUE(room_pose_errors({{1, 1, stretch(0, 0)}}, {}, Pose2{}).rooms.empty());
}

}  // namespace
}  // namespace roomatlas
