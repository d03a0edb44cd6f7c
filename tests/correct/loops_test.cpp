// SPDX-License-Identifier: GPL-3.0-or-later
// Doorways seen twice, and what the correction reports of its measurements.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "correct/corrected.hpp"

namespace roomatlas {
namespace {

using test::chain_mission;
using test::corrected;
using test::options_of;
using test::round_the_block;
using test::same_doorway;

/// Distance between where two ASRs begin.
double apart_m(const Placement& placement, AsrId one, AsrId other) {
  return (placement.at(one).position() - placement.at(other).position()).norm();
}

CorrectOptions without_walls(CorrectionModel model) {
  CorrectOptions options = options_of(model);
  options.use_wall_directions = false;
  return options;
}

const FactorReport& doorway_of(const Correction& correction) {
  const auto& factors = correction.factors;
  // with rotations alone a doorway has a factor for headings and then one for its position
  const auto last = std::find_if(factors.rbegin(), factors.rend(), [](const FactorReport& report) {
    return report.kind == FactorKind::doorway;
  });
  return *last;
}

TEST(Loops, ARecognisedDoorwayClosesTheLoop) {
  const auto visits = round_the_block(2.0);
  const auto asrs = chain_mission(visits);
  const Placement odometry = test::odometry_placement(asrs);
  ASSERT_GT(apart_m(odometry, 2, 6), 1.0);
  for (const auto model : {CorrectionModel::se2, CorrectionModel::rotation_only}) {
    const Correction correction = corrected(asrs, without_walls(model), {same_doorway(2, 6)});
    EXPECT_TRUE(correction.converged) << correction.message;
    EXPECT_LT(apart_m(placement_of(correction), 2, 6), 0.5) << correction.model;
    EXPECT_LT(doorway_of(correction).chi_square_after,
              doorway_of(correction).chi_square_before / 10.0);
    EXPECT_GT(doorway_of(correction).weight, 0.3);
  }
}

TEST(Loops, WithWallsTooTheClosedLoopIsTheTrueOne) {
  const auto visits = round_the_block(4.0);
  const Placement truth = test::true_placement(visits);
  for (const auto model : {CorrectionModel::se2, CorrectionModel::rotation_only}) {
    const Correction correction =
        corrected(chain_mission(visits), options_of(model), {same_doorway(2, 6)});
    const auto error = test::largest_error(placement_of(correction), truth);
    EXPECT_LT(error.position_m, 0.3) << correction.model;
    EXPECT_LT(error.heading_deg, 1.0) << correction.model;
  }
}

TEST(Loops, WithRotationsAlonePositionsFollowFromThePivots) {
  const auto asrs = chain_mission(round_the_block(4.0));
  const Correction correction =
      corrected(asrs, options_of(CorrectionModel::rotation_only), {same_doorway(2, 6)});
  for (std::size_t i = 0; i + 1 < asrs.size(); ++i) {
    const Pose2& here = correction.asrs[i].building_from_asr;
    const Pose2& next = correction.asrs[i + 1].building_from_asr;
    const Point2 pivot = asrs[i].exits.back().frame_from_pivot.position();
    EXPECT_LT((here * pivot - next.position()).norm(), 1e-9);
    EXPECT_NEAR((next.position() - here.position()).norm(), pivot.norm(), 1e-9);
  }
}

TEST(Loops, ADoorwayMetFromTheOtherSideClosesALoopToo) {
  // out of a room and back through the same doorway, which then lies half a turn on
  const Ring room = test::rectangle(0, 0, 6, 4);
  const Ring hall = test::rectangle(6, -10, 9, 10);
  auto asrs = chain_mission({{room, test::pose_deg(1, 2, 0)},
                             {hall, test::pose_deg(6, 2, 0)},
                             {room, test::pose_deg(6, 2, 180)}});
  // odometry is 0.3 m off when the robot is back
  asrs[1].exits.back().frame_from_pivot.y_m += 0.3;
  asrs[2].odom_from_asr = asrs[1].odom_from_asr * asrs[1].exits.back().frame_from_pivot;
  CorrectOptions options = without_walls(CorrectionModel::se2);
  options.doorway_position_m = 0.05;
  options.odometry.position.still = 0.2;
  options.robust_sigmas = 10.0;
  const Correction correction = corrected(asrs, options, {same_doorway(2, 3, -kPi)});
  EXPECT_LT(apart_m(placement_of(correction), 2, 3), 0.1);
  EXPECT_LT(correction.final_cost, correction.initial_cost);
}

TEST(Loops, AFalseDoorwayIsGivenLittleWeightAndMovesLittle) {
  const auto asrs = chain_mission(round_the_block(0.0));
  for (const auto model : {CorrectionModel::se2, CorrectionModel::rotation_only}) {
    const Correction correction =
        corrected(asrs, options_of(model), {same_doorway(2, 6), same_doorway(2, 4)});
    const FactorReport& wrong = doorway_of(correction);
    ASSERT_EQ(wrong.to, 4);
    EXPECT_LT(wrong.weight, 0.02) << correction.model;
    for (const AsrCorrection& asr : correction.asrs) {
      EXPECT_LT(asr.moved_m, 0.3) << correction.model << ", ASR " << asr.asr;
    }
  }
}

TEST(Loops, ADrivenEdgeBackToAnEarlierAsrIsAMeasurementLikeAnyOther) {
  const auto visits = round_the_block(2.0);
  PassageEdge back;  // from the last ASR into the second, as the last is the second again
  back.from = 6;
  back.to = 2;
  for (const auto model : {CorrectionModel::se2, CorrectionModel::rotation_only}) {
    const Correction correction =
        corrected(chain_mission(visits), options_of(model), {back, same_doorway(1, 5)});
    EXPECT_TRUE(correction.converged) << correction.message;
    const auto odometry = std::count_if(
        correction.factors.begin(), correction.factors.end(),
        [](const FactorReport& factor) { return factor.kind == FactorKind::odometry; });
    EXPECT_EQ(odometry, 6);
  }
}

/// Sum over factors of rho(chi-square) / 2, where rho is Cauchy's or the identity.
double cost_of(const Correction& correction, double robust_sigmas) {
  const double scale = robust_sigmas * robust_sigmas;
  double cost = 0.0;
  for (const FactorReport& factor : correction.factors) {
    const double chi_square = factor.chi_square_after;
    const bool is_robust = factor.kind != FactorKind::odometry;
    cost += 0.5 * (is_robust ? scale * std::log1p(chi_square / scale) : chi_square);
  }
  return cost;
}

TEST(Reports, CostsAndChiSquaresAgree) {
  const auto asrs = chain_mission(round_the_block(4.0));
  for (const auto model : {CorrectionModel::se2, CorrectionModel::rotation_only}) {
    for (const bool use_walls : {true, false}) {
      CorrectOptions options = options_of(model);
      options.use_wall_directions = use_walls;
      const Correction correction =
          corrected(asrs, options, {same_doorway(2, 6), same_doorway(2, 5)});
      EXPECT_GE(correction.final_cost, 0.0);
      EXPECT_LE(correction.final_cost, correction.initial_cost);
      EXPECT_NEAR(cost_of(correction, options.robust_sigmas), correction.final_cost,
                  1e-9 * (1.0 + correction.final_cost));
    }
  }
}

TEST(Reports, HoldOneFactorForEachMeasurementInTheOrderAdded) {
  const auto asrs = chain_mission(round_the_block(1.0));
  const Correction correction =
      corrected(asrs, options_of(CorrectionModel::se2), {same_doorway(2, 6)});
  ASSERT_EQ(correction.factors.size(), 5u + 1u + 6u);
  for (std::size_t i = 0; i < correction.factors.size(); ++i) {
    const FactorReport& factor = correction.factors[i];
    EXPECT_GE(factor.chi_square_before, 0.0);
    EXPECT_GE(factor.chi_square_after, 0.0);
    if (i < 5) {
      EXPECT_EQ(factor.kind, FactorKind::odometry);
      EXPECT_EQ(factor.to, factor.from + 1);
      EXPECT_NEAR(factor.chi_square_before, 0.0, 1e-12) << "odometry agrees with itself";
      EXPECT_EQ(factor.weight, 1.0);
    } else if (i == 5) {
      EXPECT_EQ(factor.kind, FactorKind::doorway);
      EXPECT_EQ(factor.from, 2);
      EXPECT_EQ(factor.to, 6);
    } else {
      EXPECT_EQ(factor.kind, FactorKind::wall_direction);
      EXPECT_EQ(factor.to, 0);
    }
  }
}

}  // namespace
}  // namespace roomatlas
