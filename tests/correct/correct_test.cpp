// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/core/pose2.hpp"

#include <gtest/gtest.h>

#include "correct/corrected.hpp"

namespace roomatlas {

/// In the names of tests.
static void PrintTo(CorrectionModel model, std::ostream* out) {
  *out << (model == CorrectionModel::se2 ? "se2" : "rotation");
}

namespace {

using test::chain_mission;
using test::corrected;
using test::largest_error;
using test::options_of;
using test::pose_deg;
using test::rectangle;
using test::round_the_block;
using test::true_placement;
using test::Visit;

/// What holds for both models.
class BothModels : public testing::TestWithParam<CorrectionModel> {
 protected:
  const CorrectOptions options_ = options_of(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Correct, BothModels,
                         testing::Values(CorrectionModel::se2, CorrectionModel::rotation_only),
                         [](const auto& tested) {
                           return tested.param == CorrectionModel::se2 ? "Se2" : "RotationOnly";
                         });

TEST_P(BothModels, PerfectOdometryStaysWhereItIs) {
  const Correction correction = corrected(chain_mission(round_the_block(0.0)), options_);
  EXPECT_TRUE(correction.converged) << correction.message;
  ASSERT_EQ(correction.asrs.size(), 6u);
  for (const AsrCorrection& asr : correction.asrs) {
    EXPECT_LT(asr.moved_m, 1e-9) << "ASR " << asr.asr;
    EXPECT_NEAR(asr.turned_rad, 0.0, 1e-9) << "ASR " << asr.asr;
  }
  EXPECT_LT(correction.final_cost, 1e-12);
}

TEST_P(BothModels, ADriftedChainComesBackToTheTruthByTheDirectionOfItsWalls) {
  for (const double drift_deg : {3.0, -4.0}) {
    const auto visits = round_the_block(drift_deg);
    const auto asrs = chain_mission(visits);
    const auto before = largest_error(test::odometry_placement(asrs), true_placement(visits));
    ASSERT_GT(before.heading_deg, 14.0);
    ASSERT_GT(before.position_m, 1.5);

    const Correction correction = corrected(asrs, options_);
    EXPECT_TRUE(correction.converged) << correction.message;
    const auto after = largest_error(placement_of(correction), true_placement(visits));
    EXPECT_LT(after.heading_deg, 1.5) << drift_deg;
    EXPECT_LT(after.position_m, 0.4) << drift_deg;
  }
}

TEST_P(BothModels, WithoutWallsOrRecognisedDoorwaysOdometryStandsAsItIs) {
  auto asrs = chain_mission(round_the_block(3.0));
  for (Asr& asr : asrs) asr.walls.clear();
  const Correction without_walls = corrected(asrs, options_);
  CorrectOptions walls_off = options_;
  walls_off.use_wall_directions = false;
  const Correction not_used = corrected(chain_mission(round_the_block(3.0)), walls_off);
  for (const Correction& correction : {without_walls, not_used}) {
    for (const AsrCorrection& asr : correction.asrs) EXPECT_LT(asr.moved_m, 1e-9);
    for (const FactorReport& factor : correction.factors) {
      EXPECT_EQ(factor.kind, FactorKind::odometry);
    }
  }
}

TEST_P(BothModels, TheBuildingsWallsComeOutAlongTheAxesAfterAtMostAnEighthTurn) {
  for (const double turned_deg : {-80.0, -40.0, 10.0, 30.0, 60.0}) {
    const auto visits = round_the_block(2.0);
    const Correction correction =
        corrected(chain_mission(visits, pose_deg(3.0, -7.0, turned_deg)), options_);
    for (const AsrCorrection& asr : correction.asrs) {
      EXPECT_NEAR(degrees(wrap_quarter(asr.building_from_asr.theta_rad)), 0.0, 1.5) << turned_deg;
    }
    const double first_deg =
        degrees(correction.asrs[0].building_from_asr.theta_rad);  // truly 0, along its wall
    EXPECT_LE(std::abs(wrap_angle(radians(first_deg - turned_deg))), radians(45.0 + 1.5));
  }
}

TEST_P(BothModels, OneAsrOfEachComponentKeepsItsOdometryPose) {
  auto visits = round_the_block(3.0);
  visits[3].is_linked = false;
  const Correction correction = corrected(chain_mission(visits), options_);
  const std::vector<std::int64_t> components = {0, 0, 0, 1, 1, 1};
  ASSERT_EQ(correction.asrs.size(), components.size());
  for (std::size_t i = 0; i < components.size(); ++i) {
    const AsrCorrection& asr = correction.asrs[i];
    EXPECT_EQ(asr.component, components[i]);
    const bool is_first = i == 0 || components[i] != components[i - 1];
    EXPECT_EQ(asr.moved_m == 0.0 && asr.turned_rad == 0.0, is_first) << "ASR " << asr.asr;
  }
}

TEST_P(BothModels, WallsFartherFromTheBuildingsDirectionThanTheGateAreNotBentIntoIt) {
  // a wing at 35 degrees behind a rectilinear room; odometry is perfect
  const Pose2 wing = pose_deg(6, 2, 35);
  const std::vector<Visit> visits = {
      {rectangle(0, 0, 6, 4), pose_deg(1, 2, 0)},
      {transformed(wing, rectangle(0, -1, 10, 1)), wing},
      {transformed(wing, rectangle(10, -3, 16, 3)), wing * Pose2{10, 0, 0}},
  };
  CorrectOptions options = options_;
  options.wall_gate_deg = 25.0;
  const Correction correction = corrected(chain_mission(visits), options);
  for (const AsrCorrection& asr : correction.asrs) EXPECT_LT(asr.moved_m, 1e-6);
  const auto heading_deg = [&](std::size_t i) {
    return degrees(correction.asrs[i].building_from_asr.theta_rad);
  };
  EXPECT_NEAR(heading_deg(2) - heading_deg(0), 35.0, 1e-6);
}

TEST_P(BothModels, AMissionThatBeginsInAWingAtAnAngleFollowsTheRestOfTheBuilding) {
  // off the block's south corridor, through a doorway that the corridor shows as a straight one
  auto visits = round_the_block(3.0);
  visits.insert(visits.begin(), {rectangle(-2, -2, 6, 2), {}, 3.0});
  const Pose2 wing = pose_deg(1, -5, 35);
  visits[0].room = transformed(wing, visits[0].room);
  visits[0].entered_at = wing;
  const Correction correction = corrected(chain_mission(visits), options_);
  const auto error = largest_error(placement_of(correction), true_placement(visits));
  EXPECT_LT(error.heading_deg, 5.0);  // the wing itself stays as odometry has it
  EXPECT_LT(error.position_m, 1.0);
  for (std::size_t i = 1; i < visits.size(); ++i) {
    EXPECT_NEAR(degrees(wrap_quarter(correction.asrs[i].building_from_asr.theta_rad)), 0.0, 1.5);
  }
}

TEST_P(BothModels, ATriangularRoomHasNoDirectionToFollow) {
  const std::vector<Visit> visits = {
      {rectangle(0, 0, 6, 4), pose_deg(1, 2, 0)},
      {{{6, -3}, {14, 2}, {6, 7}}, pose_deg(6, 2, 0), 10.0},
      {rectangle(14, 0, 20, 4), pose_deg(14, 2, 0)},
  };
  const Correction correction = corrected(chain_mission(visits), options_);
  for (const FactorReport& factor : correction.factors) {
    EXPECT_FALSE(factor.kind == FactorKind::wall_direction && factor.from == 2);
  }
}

TEST_P(BothModels, TwoRunsGiveTheSameBits) {
  const auto asrs = chain_mission(round_the_block(3.0));
  const auto edges = {test::same_doorway(2, 6)};
  const Correction one = corrected(asrs, options_, edges);
  const Correction other = corrected(asrs, options_, edges);
  EXPECT_EQ(one.final_cost, other.final_cost);
  ASSERT_EQ(one.asrs.size(), other.asrs.size());
  for (std::size_t i = 0; i < one.asrs.size(); ++i) {
    EXPECT_EQ(one.asrs[i].building_from_asr, other.asrs[i].building_from_asr);
  }
  ASSERT_EQ(one.factors.size(), other.factors.size());
  for (std::size_t i = 0; i < one.factors.size(); ++i) {
    EXPECT_EQ(one.factors[i].chi_square_after, other.factors[i].chi_square_after);
    EXPECT_EQ(one.factors[i].weight, other.factors[i].weight);
  }
}

TEST_P(BothModels, AnEmptyMissionIsCorrectedAlready) {
  const Correction correction = corrected({}, options_);
  EXPECT_TRUE(correction.converged);
  EXPECT_TRUE(correction.asrs.empty());
  EXPECT_TRUE(correction.factors.empty());
  EXPECT_TRUE(placement_of(correction).empty());
}

TEST_P(BothModels, OneAsrAloneStaysAndIsOnlyTurnedIntoItsWalls) {
  const Pose2 odometry = pose_deg(5, 6, 20);
  auto asrs = chain_mission({{rectangle(0, 0, 6, 4), pose_deg(1, 2, 0)}}, odometry);
  const Pose2 start = asrs[0].odom_from_asr;
  for (const bool has_walls : {true, false}) {
    if (!has_walls) asrs[0].walls.clear();
    const Correction correction = corrected(asrs, options_);
    EXPECT_TRUE(correction.converged) << correction.message;
    ASSERT_EQ(correction.asrs.size(), 1u);
    EXPECT_EQ(correction.asrs[0].moved_m, 0.0);
    const Pose2& pose = correction.asrs[0].building_from_asr;
    EXPECT_LT((pose.position() - start.position()).norm(), 1e-12);
    EXPECT_NEAR(degrees(pose.theta_rad), has_walls ? 0.0 : 20.0, 1e-6);
  }
}

TEST(Correction, StartsInAStateThatCannotPassForSuccess) {
  const Correction correction;
  EXPECT_FALSE(correction.converged);
  EXPECT_LT(correction.final_cost, 0.0);
  EXPECT_LT(FactorReport{}.chi_square_after, 0.0);
}

}  // namespace
}  // namespace roomatlas
