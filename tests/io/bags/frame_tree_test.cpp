// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/frame_tree.hpp"

#include <gtest/gtest.h>

namespace roomatlas::io {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

PoseMessage edge(const std::string& parent, const std::string& child, const Pose2& pose,
                 std::int64_t stamp_ns = 0) {
  return {{stamp_ns, parent}, child, upright(pose)};
}

/// The same by matrices.
Eigen::Matrix3d matrix(const Pose2& pose) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  m.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(pose.theta_rad).toRotationMatrix();
  m(0, 2) = pose.x_m;
  m(1, 2) = pose.y_m;
  return m;
}

TEST(FrameTree, AChainIsTheProductOfItsEdges) {
  const Pose2 base_from_mast{0.2, -0.1, 1.0};
  const Pose2 mast_from_laser{0.0, 0.3, -2.0};
  const Pose2 base_from_arm{-0.5, 0.0, 3.0};
  FrameTree tree;
  tree.add({edge("base", "mast", base_from_mast), edge("mast", "laser", mast_from_laser),
            edge("base", "arm", base_from_arm)},
           true);
  const auto found = tree.lookup("arm", "laser", 5, Constant::holds_always);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->beyond_ns, 0);
  const Eigen::Matrix3d expected =
      matrix(base_from_arm).inverse() * matrix(base_from_mast) * matrix(mast_from_laser);
  EXPECT_TRUE(matrix(planar(found->transform)).isApprox(expected, 1e-9));
  EXPECT_FALSE(tree.lookup("arm", "moon", 5, Constant::holds_always));
  EXPECT_TRUE(tree.are_joined("laser", "arm"));
}

TEST(FrameTree, WhatMovesIsInterpolatedAndItsEndsAreSaid) {
  FrameTree tree;
  tree.add({edge("odom", "base", {0.0, 0.0, 0.0}, 1 * kSecond)}, false);
  tree.add({edge("odom", "base", {2.0, 0.0, 1.0}, 2 * kSecond)}, false);
  const auto at = [&](std::int64_t ns) {
    return *tree.lookup("odom", "base", ns, Constant::in_its_times);
  };
  EXPECT_NEAR(planar(at(kSecond * 3 / 2).transform).x_m, 1.0, 1e-12);
  EXPECT_NEAR(planar(at(kSecond * 3 / 2).transform).theta_rad, 0.5, 1e-12);
  EXPECT_EQ(at(kSecond * 3 / 2).beyond_ns, 0);
  EXPECT_EQ(at(3 * kSecond).beyond_ns, kSecond);
  EXPECT_EQ(planar(at(3 * kSecond).transform).x_m, 2.0);
  EXPECT_EQ(at(0).beyond_ns, kSecond);
}

TEST(FrameTree, AMountThatIsPublishedForEverIsKnownForAllTimes) {
  FrameTree tree;
  tree.add({edge("base", "laser", {0.1, 0.0, 0.0}, 100 * kSecond)}, false);
  EXPECT_EQ(tree.lookup("base", "laser", 0, Constant::holds_always)->beyond_ns, 0);
  EXPECT_EQ(tree.lookup("base", "laser", 0, Constant::in_its_times)->beyond_ns, 100 * kSecond);
  tree.add({edge("base", "laser", {0.2, 0.0, 0.0}, 101 * kSecond)}, false);  // it does move
  EXPECT_EQ(tree.lookup("base", "laser", 0, Constant::holds_always)->beyond_ns, 100 * kSecond);
}

TEST(FrameTree, SamplesOutOfOrderAreSortedAndASetBackClockBeginsAnew) {
  TransformTrack track;
  using Added = TransformTrack::Added;
  EXPECT_EQ(track.add(10 * kSecond, upright({1.0, 0.0, 0.0})), Added::in_order);
  EXPECT_EQ(track.add(12 * kSecond, upright({3.0, 0.0, 0.0})), Added::in_order);
  EXPECT_EQ(track.add(11 * kSecond, upright({5.0, 0.0, 0.0})), Added::out_of_order);
  EXPECT_NEAR(track.at(kSecond * 23 / 2)->transform.translation.x(), 4.0, 1e-12);
  EXPECT_EQ(track.add(12 * kSecond, upright({9.0, 0.0, 0.0})), Added::again);
  EXPECT_EQ(track.at(12 * kSecond)->transform.translation.x(), 3.0);
  EXPECT_EQ(track.add(1 * kSecond, upright({7.0, 0.0, 0.0})), Added::clock_set_back);
  EXPECT_EQ(track.at(12 * kSecond)->transform.translation.x(), 7.0);
}

TEST(FrameTree, AClockSetBackByLessThanATrackKeepsBeginsAnew) {
  using Added = TransformTrack::Added;
  const auto ten_times_a_second = [](int first, int last, double x_m, TransformTrack& track) {
    for (int i = first; i < last; ++i) {
      (void)track.add(i * kSecond / 10, upright({x_m + 0.1 * i, 0.0, 0.0}));
    }
  };
  TransformTrack track;
  ten_times_a_second(0, 100, 0.0, track);
  // late by little, or told again, or where nothing else was told: only late
  EXPECT_EQ(track.add(95 * kSecond / 10 + 1, upright({9.5, 0.0, 0.0})), Added::out_of_order);
  EXPECT_EQ(track.add(50 * kSecond / 10, upright({5.0, 0.0, 0.0})), Added::again);
  TransformTrack silent;
  ten_times_a_second(0, 10, 0.0, silent);
  ten_times_a_second(50, 60, 0.0, silent);
  EXPECT_EQ(silent.add(20 * kSecond / 10, upright({2.0, 0.0, 0.0})), Added::out_of_order);
  // between others, or at the very time of one
  EXPECT_EQ(track.add(50 * kSecond / 10 + 1, upright({9.9, 0.0, 0.0})), Added::clock_set_back);
  ten_times_a_second(51, 90, 4.0, track);
  EXPECT_NEAR(track.at(70 * kSecond / 10)->transform.translation.x(), 11.0, 1e-12);
  EXPECT_EQ(track.add(60 * kSecond / 10, upright({13.0, 0.0, 0.0})), Added::clock_set_back);
  EXPECT_EQ(track.at(80 * kSecond / 10)->transform.translation.x(), 13.0);
}

TEST(FrameTree, ATrackIsBoundedAndKeepsWhatASilenceIsInterpolatedFrom) {
  TransformTrack track;
  for (int i = 0; i < 100'000; ++i) {
    (void)track.add(i * kSecond / 100, upright({0.01 * i, 0.0, 0.0}));
  }
  EXPECT_GT(track.at(0)->beyond_ns, 900 * kSecond);  // forgotten
  (void)track.add(1100 * kSecond, upright({1100.0, 0.0, 0.0}));
  EXPECT_NEAR(track.at(1050 * kSecond)->transform.translation.x(), 1050.0, 0.1);
}

TEST(FrameTree, ARingOfFramesAndUnsoundTransformsAreNoHarm) {
  FrameTree tree;
  tree.add({edge("a", "b", {}), edge("b", "a", {}), edge("c", "c", {}), edge("", "d", {})}, true);
  PoseMessage unsound = edge("a", "e", {});
  unsound.frame_from_child.reset();
  tree.add({unsound}, true);
  EXPECT_EQ(tree.unsound(), 3);
  (void)tree.lookup("a", "b", 0, Constant::holds_always);
  (void)tree.lookup("x", "b", 0, Constant::holds_always);
  EXPECT_FALSE(tree.lookup("a", "e", 0, Constant::holds_always));
}

}  // namespace
}  // namespace roomatlas::io
