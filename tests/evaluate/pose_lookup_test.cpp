// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/pose_lookup.hpp"

#include <gtest/gtest.h>

#include "evaluate/drives.hpp"

namespace roomatlas {
namespace {

const Trajectory kDrive = {{10.0, {0, 0, 0}}, {12.0, {4, 2, 0.4}}, {13.0, {5, 2, -3.0}}};

double x_at(const Trajectory& drive, const MatchOptions& options, double time_s) {
  const auto found = PoseLookup(drive, options).at(time_s);
  return found ? found->pose.x_m : -1.0;
}

TEST(PoseLookup, ExactAnswersToTheMicrosecondOnly) {
  EXPECT_EQ(x_at(kDrive, {}, 12.0), 4.0);
  EXPECT_EQ(x_at(kDrive, {}, 12.0000004), 4.0);
  EXPECT_EQ(x_at(kDrive, {}, 12.000001), -1.0);
}

TEST(PoseLookup, NearestAnswersWithinTheGapAndNamesIt) {
  EXPECT_EQ(x_at(kDrive, {TimeMatch::nearest, {}}, 11.6), 4.0);
  EXPECT_EQ(x_at(kDrive, {TimeMatch::nearest, {}}, 11.4), -1.0);
  EXPECT_EQ(x_at(kDrive, {TimeMatch::nearest, 0.7}, 11.4), 4.0);
  EXPECT_EQ(x_at(kDrive, {TimeMatch::nearest, 100.0}, 3.0), 0.0);
  const auto found = PoseLookup(kDrive, {TimeMatch::nearest, {}}).at(13.25);
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->gap_s, 0.25);
  EXPECT_EQ(found->by, FoundPose::By::nearest);
}

TEST(PoseLookup, InterpolatesBetweenNeighboursAndTurnsTheShortWay) {
  const PoseLookup lookup(kDrive, {TimeMatch::interpolate, {}});
  const auto found = lookup.at(12.5);
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->pose.x_m, 4.5);
  const Pose2 between = interpolate(kDrive[1].pose, kDrive[2].pose, 0.5);
  EXPECT_EQ(found->pose, between);
  EXPECT_FALSE(lookup.at(9.9));
  EXPECT_FALSE(lookup.at(13.1));
  EXPECT_FALSE(PoseLookup(kDrive, {TimeMatch::interpolate, 1.5}).at(11.0));
  EXPECT_TRUE(PoseLookup(kDrive, {TimeMatch::interpolate, 1.5}).at(12.5));
}

TEST(PoseLookup, NeverInterpolatesAcrossAStepBackOfTheClock) {
  const Trajectory drive = {
      {10.0, {0, 0, 0}}, {20.0, {10, 0, 0}}, {5.0, {100, 0, 0}}, {6.0, {101, 0, 0}}};
  const MatchOptions options{TimeMatch::interpolate, {}};
  EXPECT_EQ(x_at(drive, options, 15.0), 5.0);
  EXPECT_EQ(x_at(drive, options, 5.5), 100.5);
  EXPECT_EQ(x_at(drive, options, 8.0), -1.0);
}

TEST(PoseLookup, OfTwoPlacesWithOneTimeTheFirstAnswersAndInFileOrderTheNextOneOn) {
  const Trajectory drive = {{1.0, {1, 0, 0}},  {2.0, {2, 0, 0}},  {3.0, {3, 0, 0}},
                            {1.0, {11, 0, 0}}, {2.0, {12, 0, 0}}, {3.0, {13, 0, 0}}};
  EXPECT_EQ(x_at(drive, {}, 2.0), 2.0);
  PoseLookup lookup(drive, {});
  for (const StampedPose& stamped : drive) {
    const auto found = lookup.next(stamped.timestamp_s);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->pose.x_m, stamped.pose.x_m);
  }
}

TEST(PoseLookup, CarriesThePoseBeforeOnByOdometryOfAnyFrame) {
  const Trajectory truth = test::bent(200);
  Trajectory sparse;
  for (std::size_t i = 10; i < truth.size(); i += 25) sparse.push_back(truth[i]);
  const Trajectory odometry = test::disturbed(truth, 0.0, {-3.0, 8.0, 1.1});
  const PoseLookup lookup(sparse, {}, &odometry);
  for (const StampedPose& stamped : truth) {
    const auto found = lookup.at(stamped.timestamp_s);
    ASSERT_TRUE(found);
    EXPECT_NEAR((found->pose.position() - stamped.pose.position()).norm(), 0.0, 1e-9);
    EXPECT_NEAR(wrap_angle(found->pose.theta_rad - stamped.pose.theta_rad), 0.0, 1e-9);
  }
  EXPECT_EQ(lookup.at(truth[11].timestamp_s)->by, FoundPose::By::odometry);
  EXPECT_EQ(lookup.at(truth[10].timestamp_s)->by, FoundPose::By::exact);
  EXPECT_FALSE(lookup.at(1e6));
}

TEST(PoseLookup, InterpolatesShortGapsAndCarriesLongOnes) {
  const Trajectory odometry = {{0.0, {0, 0, 0}}, {10.0, {10, 0, 0}}};
  const Trajectory drive = {{0.0, {0, 0, 0}}, {1.0, {2, 0, 0}}, {9.0, {3, 0, 0}}};
  const PoseLookup lookup(drive, {TimeMatch::interpolate, 2.0}, &odometry);
  EXPECT_DOUBLE_EQ(lookup.at(0.5)->pose.x_m, 1.0);
  EXPECT_DOUBLE_EQ(lookup.at(5.0)->pose.x_m, 6.0);  // 2 m, and 4 s of 1 m/s
}

TEST(PoseLookup, PassesOverTimesThatAreNotFinite) {
  const double nan = std::nan("");
  const Trajectory drive = {{1.0, {1, 0, 0}}, {nan, {9, 0, 0}}, {3.0, {3, 0, 0}}};
  EXPECT_EQ(x_at(drive, {TimeMatch::interpolate, {}}, 2.0), 2.0);
  EXPECT_EQ(x_at(drive, {TimeMatch::nearest, 10.0}, nan), -1.0);
  EXPECT_EQ(x_at({}, {TimeMatch::nearest, 10.0}, 1.0), -1.0);
}

TEST(PoseLookup, SaysWhereItsPosesCameFrom) {
  MatchUse use;
  const PoseLookup lookup(kDrive, {TimeMatch::interpolate, {}});
  count(use, *lookup.at(10.0));
  count(use, *lookup.at(11.0));
  EXPECT_EQ(to_string(use), "2 poses: 1 exact, 1 interpolated (gaps up to 2 s)");
  EXPECT_EQ(to_string(MatchUse{}), "no poses");
}

}  // namespace
}  // namespace roomatlas
