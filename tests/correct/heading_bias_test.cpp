// SPDX-License-Identifier: GPL-3.0-or-later
// Odometry whose heading drifts with the way driven: the walls show it.
#include <gtest/gtest.h>

#include "correct/corrected.hpp"

namespace roomatlas {
namespace {

/// Twice round the block, with a heading that drifts by so much a metre driven.
std::vector<test::Visit> drifting(double deg_per_m) {
  auto visits = test::round_the_block(0.0);
  for (int i = 2; i < 6; ++i) visits.push_back(visits[static_cast<std::size_t>(i)]);
  const auto without_drift = test::chain_mission(visits);
  for (std::size_t i = 0; i < visits.size(); ++i) {
    visits[i].drift_deg = deg_per_m * path_length_m(without_drift[i]);
  }
  return visits;
}

TEST(HeadingBias, IsFoundWithItsSign) {
  for (const double deg_per_m : {-0.6, 0.0, 0.6}) {
    const Correction correction = test::corrected(test::chain_mission(drifting(deg_per_m)), {});
    EXPECT_EQ(correction.odometry_bias.asrs, 10);
    EXPECT_NEAR(degrees(correction.odometry_bias.rad_per_m), deg_per_m, 0.3);
  }
}

TEST(HeadingBias, TakenOutLeavesTheTruth) {
  for (const auto model : {CorrectionModel::se2, CorrectionModel::rotation_only}) {
    const auto visits = drifting(0.6);
    const Correction correction =
        test::corrected(test::chain_mission(visits), test::options_of(model));
    const auto error = test::largest_error(placement_of(correction), test::true_placement(visits));
    EXPECT_LT(error.heading_deg, 1.0) << correction.model;
    EXPECT_LT(error.position_m, 0.3) << correction.model;
  }
}

TEST(HeadingBias, IsNotEstimatedWithoutWallsFromFewAsrsOrWhenTurnedOff) {
  EXPECT_EQ(test::corrected(test::chain_mission(test::round_the_block(2.0)), {}).odometry_bias.asrs,
            0);
  CorrectOptions off;
  off.use_heading_bias = false;
  const auto asrs = test::chain_mission(drifting(0.6));
  EXPECT_EQ(test::corrected(asrs, off).odometry_bias.rad_per_m, 0.0);
  CorrectOptions without_walls;
  without_walls.use_wall_directions = false;
  const Correction correction = test::corrected(asrs, without_walls);
  EXPECT_EQ(correction.odometry_bias.asrs, 0);
  for (const AsrCorrection& asr : correction.asrs) EXPECT_LT(asr.moved_m, 1e-9);
}

}  // namespace
}  // namespace roomatlas
