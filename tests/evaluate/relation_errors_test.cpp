// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "roomatlas/evaluate/evaluate.hpp"

namespace roomatlas {
namespace {

using ::testing::HasSubstr;

constexpr double kStart_s = 976052857.345321;  // as large as the stamps of real logs

/// A pose every 0.25 s along a bent path.
Trajectory bent_drive() {
  Trajectory drive;
  for (int i = 0; i < 400; ++i) {
    const double s = 0.1 * i;
    drive.push_back({kStart_s + 0.25 * i, {s, std::sin(s), wrap_angle(0.2 * s)}});
  }
  return drive;
}

/// Every 7th pose against the one `steps` later, exactly.
std::vector<Relation> relations_of(const Trajectory& truth, std::size_t steps) {
  std::vector<Relation> relations;
  for (std::size_t i = 0; i + steps < truth.size(); i += 7) {
    const auto& [t1_s, pose1] = truth[i];
    const auto& [t2_s, pose2] = truth[i + steps];
    relations.push_back({t1_s, t2_s, inverse(pose1) * pose2});
  }
  return relations;
}

TEST(RelationErrors, OfAPerfectTrajectoryAreZero) {
  const Trajectory drive = bent_drive();
  const RelationErrors errors = relation_errors(drive, relations_of(drive, 40), {});
  EXPECT_EQ(errors.relations, 52);
  EXPECT_EQ(errors.matched, 52);
  EXPECT_EQ(errors.all.translation_m.count, 52);
  EXPECT_LT(errors.all.translation_m.maximum, 1e-12);
  EXPECT_LT(errors.all.rotation_deg.maximum, 1e-12);
  EXPECT_TRUE(errors.issues.empty());
}

TEST(RelationErrors, OfAKnownMistakeAreThatMistake) {
  // Both see the second pose 3 m ahead; the first says straight on, the second 90 degrees left,
  // which moves a point 3 m ahead to 3 m left: an error of 3 sqrt(2) m.
  const Trajectory drive = {{1.0, {10, 20, 0}}, {2.0, {13, 20, 0}}, {3.0, {13, 23, kPi / 2}}};
  const std::vector<Relation> relations = {{1.0, 2.0, {3, 0.5, radians(-10)}},
                                           {2.0, 3.0, {3, 0, 0}}};
  const RelationErrors errors = relation_errors(drive, relations, {});
  EXPECT_NEAR(errors.all.translation_m.mean, (0.5 + 3.0 * std::sqrt(2.0)) / 2.0, 1e-12);
  EXPECT_NEAR(errors.all.rotation_deg.mean, (10.0 + 90.0) / 2.0, 1e-12);
  EXPECT_NEAR(errors.all.translation_m.maximum, 3.0 * std::sqrt(2.0), 1e-12);
}

TEST(RelationErrors, OfAHeadingThatDriftsAreTheDriftBetweenTheTwoPoses) {
  // A straight true drive; the estimate turns by 1 degree each step on the spot where it is.
  Trajectory drive;
  std::vector<Relation> relations;
  for (int i = 0; i < 20; ++i) {
    drive.push_back({static_cast<double>(i), {static_cast<double>(i), 0, radians(i)}});
  }
  for (int i = 0; i + 5 < 20; ++i) relations.push_back({1.0 * i, i + 5.0, {5, 0, 0}});
  const RelationErrors errors = relation_errors(drive, relations, {});
  EXPECT_NEAR(errors.all.rotation_deg.mean, 5.0, 1e-9);
  // The first pose's heading is wrong by i degrees: the chord of a 5 m radius.
  double sum = 0.0;
  for (int i = 0; i < 15; ++i) sum += 2.0 * 5.0 * std::sin(radians(i) / 2.0);
  EXPECT_NEAR(errors.all.translation_m.mean, sum / 15.0, 1e-12);
}

TEST(RelationErrors, RotationErrorsTakeTheShortWayRound) {
  const Trajectory drive = {{1.0, {0, 0, radians(-179)}}, {2.0, {0, 0, radians(179)}}};
  const RelationErrors errors = relation_errors(drive, {{1.0, 2.0, {}}}, {});
  EXPECT_NEAR(errors.all.rotation_deg.mean, 2.0, 1e-9);
}

TEST(RelationErrors, DoNotChangeWhenTheTrajectoryMovesAsAWhole) {
  Trajectory drive = bent_drive();
  const std::vector<Relation> relations = relations_of(drive, 160);
  for (std::size_t i = 0; i < drive.size(); ++i) {
    drive[i].pose.theta_rad = wrap_angle(drive[i].pose.theta_rad + 0.001 * static_cast<double>(i));
  }
  const RelationErrors before = relation_errors(drive, relations, {});
  const Pose2 other_from_map{-40, 7.5, 2.9};
  for (StampedPose& stamped : drive) stamped.pose = other_from_map * stamped.pose;
  const RelationErrors after = relation_errors(drive, relations, {});
  EXPECT_GT(before.all.translation_m.mean, 0.1);
  EXPECT_NEAR(before.all.translation_m.mean, after.all.translation_m.mean, 1e-9);
  EXPECT_NEAR(before.all.rotation_deg.mean, after.all.rotation_deg.mean, 1e-9);
  EXPECT_NEAR(before.loop.translation_m.maximum, after.loop.translation_m.maximum, 1e-9);
}

TEST(RelationErrors, SplitLocalFromLoopByTheTimeBetweenThePoses) {
  const Trajectory drive = {{0.0, {}}, {29.9, {1, 0, 0}}, {30.0, {1, 0, 0}}, {90.0, {1, 0, 0}}};
  const std::vector<Relation> relations = {{0.0, 29.9, {}}, {0.0, 30.0, {}}, {90.0, 0.0, {}}};
  const RelationErrors errors = relation_errors(drive, relations, {.split_s = 30.0});
  EXPECT_EQ(errors.all.translation_m.count, 3);
  EXPECT_EQ(errors.local.translation_m.count, 1);
  EXPECT_EQ(errors.loop.rotation_deg.count, 2);
  EXPECT_DOUBLE_EQ(errors.local.translation_m.mean, 1.0);
}

TEST(RelationErrors, CountUnmatchedRelationsAndNameTheFirstFew) {
  const Trajectory drive = {{1.0, {}}, {2.0, {}}};
  std::vector<Relation> relations = {{1.0, 2.0, {}}};
  for (int i = 0; i < 20; ++i) relations.push_back({1.0, 2.25 + i, {}});
  const RelationErrors errors = relation_errors(drive, relations, {});
  EXPECT_EQ(errors.relations, 21);
  EXPECT_EQ(errors.matched, 1);
  ASSERT_EQ(errors.issues.size(), 6U);
  EXPECT_EQ(errors.issues[0].severity, Severity::warning);
  EXPECT_THAT(errors.issues[0].message, HasSubstr("20 of 21"));
  EXPECT_EQ(errors.issues[1].field, "relation 2");
  EXPECT_THAT(errors.issues[1].message, HasSubstr("t1 = 1.000000, t2 = 2.250000"));
  EXPECT_THAT(errors.issues[1].message, HasSubstr("no pose at t2 (nearest 0.250000 s away)"));
}

TEST(RelationErrors, AreAnErrorWhenNothingMatches) {
  const RelationErrors errors = relation_errors({}, {{1.0, 2.0, {}}}, {});
  EXPECT_EQ(errors.matched, 0);
  EXPECT_TRUE(std::isnan(errors.all.translation_m.mean));
  ASSERT_EQ(errors.issues.size(), 2U);
  EXPECT_EQ(errors.issues[0].severity, Severity::error);
  EXPECT_THAT(errors.issues[1].message, HasSubstr("no pose at t1 and t2;"));
}

TEST(RelationErrors, OfNoRelationsAreEmptyAndNoIssue) {
  const RelationErrors errors = relation_errors(bent_drive(), {}, {});
  EXPECT_EQ(errors.relations, 0);
  EXPECT_EQ(errors.all.translation_m.count, 0);
  EXPECT_TRUE(errors.issues.empty());
}

TEST(RelationErrors, MatchToTheMicrosecondAndNoFurther) {
  const Trajectory drive = {{kStart_s, {}}, {kStart_s + 1.0, {}}};
  const auto matched = [&](double offset_s) {
    return relation_errors(drive, {{kStart_s, kStart_s + 1.0 + offset_s, {}}}, {}).matched;
  };
  EXPECT_EQ(matched(0.0), 1);
  EXPECT_EQ(matched(0.25e-6), 1);
  EXPECT_EQ(matched(1e-6), 0);
  EXPECT_EQ(matched(-1e-6), 0);
  EXPECT_EQ(matched(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(matched(std::numeric_limits<double>::infinity()), 0);
}

TEST(RelationErrors, UseTheFirstPoseOfATimestampThatOccursTwice) {
  const Trajectory drive = {{1.0, {}}, {2.0, {5, 0, 0}}, {2.0, {9, 0, 0}}};
  const RelationErrors errors = relation_errors(drive, {{1.0, 2.0, {5, 0, 0}}}, {});
  EXPECT_DOUBLE_EQ(errors.all.translation_m.mean, 0.0);
}

TEST(RelationErrors, AreTheSameWhenTimestampsStepBack) {
  const Trajectory drive = {{5.0, {}}, {7.0, {2, 0, 0}}, {6.0, {3, 0, 0}}, {8.0, {4, 0, 0}}};
  const RelationErrors errors = relation_errors(drive, {{5.0, 6.0, {3, 0, 0}}}, {});
  EXPECT_EQ(errors.matched, 1);
  EXPECT_DOUBLE_EQ(errors.all.translation_m.mean, 0.0);
}

}  // namespace
}  // namespace roomatlas
