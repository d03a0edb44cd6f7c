// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/noise.hpp"

#include <gtest/gtest.h>

namespace roomatlas {
namespace {

constexpr MotionSigma kSigma{.still = 2.0, .per_m = 3.0, .per_sqrt_m = 6.0, .per_rad = 5.0};

TEST(MotionSigma, AddsItsPartsWhereTheyHaveOneCause) {
  EXPECT_DOUBLE_EQ(plain_sum(kSigma, 4.0, 0.5), 2.0 + 12.0 + 12.0 + 2.5);
}

TEST(MotionSigma, AddsTheirSquaresWhereTheyAreIndependent) {
  EXPECT_DOUBLE_EQ(sum_of_squares({.still = 3.0, .per_m = 2.0}, 2.0, 9.0), 25.0);
  EXPECT_DOUBLE_EQ(sum_of_squares({.per_sqrt_m = 1.5, .per_rad = 4.0}, 4.0, 1.0), 25.0);
}

TEST(MotionSigma, IsWhatItIsStillWhereNothingMoves) {
  EXPECT_EQ(plain_sum(kSigma, 0.0, 0.0), 2.0);
  EXPECT_EQ(sum_of_squares(kSigma, 0.0, 0.0), 4.0);
}

TEST(MotionSigma, OfARandomWalkDoesNotDependOnHowTheWayIsCut) {
  const MotionSigma walk{.per_sqrt_m = 0.02};
  EXPECT_DOUBLE_EQ(sum_of_squares(walk, 4.0, 0.0), 2.0 * sum_of_squares(walk, 2.0, 0.0));
}

}  // namespace
}  // namespace roomatlas
